// Makes materials from recordings for the window: what was struck, and the finished material in the
// user's folder and in the sound.
#pragma once

#include "Editor/MaterialFitView.h"
#include "Plugin/HostParameters.h"
#include "Plugin/ImportSession.h"
#include "Plugin/MaterialSession.h"
#include "Plugin/MaterialWorkshop.h"
#include "Plugin/SoundSession.h"

#include <memory>
#include <optional>
#include <string>

namespace idiophone {

/// For the message thread.
class MaterialFitSession final : public MaterialFitView {
public:
    MaterialFitSession(const HostParameters& hostParameters,
                       SoundSession& soundSession,
                       const ImportSession& importSession,
                       MaterialSession& userMaterials)
        : parameters(hostParameters), session(soundSession), imports(importSession),
          materials(userMaterials) {}

    std::string recordingPatterns() const override;
    std::string meshPatterns() const override;
    std::string shownObject() const override;
    void fitMaterial(const RecordedStrike& strike) override;
    void cancelFit() override { workshop.cancel(); }
    MaterialFitStatus fitStatus() const override;

    /// Saves and chooses a material that is ready, and reports a failure. Call it regularly.
    void poll();

private:
    std::shared_ptr<const ModalObject> shown() const;
    double thicknessMetresOf(const ModalObject& object) const;
    std::optional<MaterialWorkshop::StruckObjectMaker> struckIn(const RecordedStrike& strike) const;
    void keep(const RecordedMaterial& made);

    const HostParameters& parameters;
    SoundSession& session;
    const ImportSession& imports;
    MaterialSession& materials;
    MaterialWorkshop workshop;
    int origin = -1;           ///< SoundSession::origin when the fit began
    MaterialFitStatus outcome; ///< of the last fit; Stage::none while one runs
};

} // namespace idiophone
