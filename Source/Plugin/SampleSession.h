// Exports samples of the current sound for the window.
#pragma once

#include "Editor/SampleView.h"
#include "Plugin/SampleWorker.h"
#include "Plugin/SoundSession.h"
#include "Plugin/TuningSession.h"

#include <optional>

namespace idiophone {

/// For the message thread.
class SampleSession final : public SampleView {
public:
    SampleSession(SharedParts& sharedParts,
                  SoundSession& soundSession,
                  const TuningSession& tuningSession)
        : shared(sharedParts), session(soundSession), tuning(tuningSession) {}

    void estimateSamples(const SampleSettings& settings) override;
    void exportSamples(const SampleSettings& settings,
                       const std::filesystem::path& parent) override;
    void stopExport() override;
    SampleStatus sampleStatus() const override { return worker.status(); }

    /// Call it regularly. Reports an export that failed.
    void poll();

private:
    /// All that an estimate or export depends on.
    struct Subject {
        SampleSettings settings;
        int loadNumber = 0;
        ParameterValues values;
        ModeSet muted;
        ScalaTuning tuning;

        bool operator==(const Subject&) const = default;
    };

    Subject subjectOf(const SampleSettings& settings) const;
    SampleOrder orderOf(const Subject& subject) const;
    bool keepsResult(const Subject& subject) const;

    SharedParts& shared;
    SoundSession& session;
    const TuningSession& tuning;
    std::optional<Subject> last; ///< of the last estimate or export
    bool failureShown = true;
    SampleWorker worker;
};

} // namespace idiophone
