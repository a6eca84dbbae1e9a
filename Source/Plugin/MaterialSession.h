// The user's own materials, and the choice of one of them for the playing objects.
#pragma once

#include "Editor/MaterialView.h"
#include "Object/Material.h"
#include "Plugin/ParameterEdits.h"
#include "Plugin/SoundHistory.h"
#include "Plugin/SoundSession.h"

#include <string>
#include <vector>

namespace idiophone {

/// For the message thread.
class MaterialSession final : public MaterialView {
public:
    MaterialSession(HostParameters& hostParameters,
                    SoundSession& soundSession,
                    SoundHistory& soundHistory,
                    ParameterEdits& parameterEdits)
        : parameters(hostParameters), session(soundSession), history(soundHistory),
          edits(parameterEdits) {}

    std::vector<std::string> readUserMaterials() override;
    std::vector<std::string> userMaterialNames() const override;
    int userMaterialIndex() const override;
    void chooseUserMaterial(int index) override;

    bool contains(const std::string& name) const;
    /// Reads the user's materials again, and chooses the one of that name.
    void choose(const std::string& name);

private:
    HostParameters& parameters;
    SoundSession& session;
    SoundHistory& history;
    ParameterEdits& edits;
    std::vector<Material> materials; ///< as read last
};

} // namespace idiophone
