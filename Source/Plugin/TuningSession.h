// Tunes the keys by Scala files, which this instance keeps in its state.
#pragma once

#include "Editor/TuningView.h"
#include "Instrument/ScalaTuning.h"
#include "Plugin/HostReporter.h"
#include "Plugin/SoundHistory.h"
#include "Plugin/SoundSession.h"

#include <functional>
#include <string>

namespace idiophone {

/// For the message thread, except functions marked [lock]: any thread that holds the session's lock
/// calls them.
class TuningSession final : public TuningView {
public:
    TuningSession(SoundSession& session,
                  TailLength& tail,
                  Tuner& tuner,
                  HostReporter& reporter,
                  SoundHistory& history);

    bool isTuningFile(const std::filesystem::path& file) const override;
    std::string tuningPatterns() const override;
    void openTuning(const std::filesystem::path& file) override;
    void forgetTuning() override;
    TuningStatus tuningStatus() const override;

    /// [lock]
    const ScalaTuning& files() const noexcept { return scala; }
    /// [lock] Sets the tuning of valid files. Moves their texts instead of copying, so that a
    /// hand-over cannot fail.
    void tuneTo(ScalaTuning files, const KeyTuning& keys) noexcept;

private:
    void record(const std::string& step, const ScalaTuning& before, const ScalaTuning& after);

    SoundSession& session;
    TailLength& tail;
    Tuner& tuner;
    HostReporter& reporter;
    SoundHistory& history;
    ScalaTuning scala; ///< under the session's lock
};

} // namespace idiophone
