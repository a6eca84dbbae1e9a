// Tunes the keys by Scala files, which this instance keeps in its state.
#pragma once

#include "Editor/TuningView.h"
#include "Instrument/ScalaTuning.h"
#include "Plugin/FileKinds.h"
#include "Plugin/SoundHistory.h"
#include "Plugin/SoundSession.h"

#include <functional>
#include <string>

namespace idiophone {

/// For the message thread, except functions marked [lock]: any thread that holds the session's lock
/// calls them.
class TuningSession final : public TuningView {
public:
    TuningSession(SharedParts& sharedParts, SoundSession& soundSession, SoundHistory& soundHistory)
        : shared(sharedParts), session(soundSession), history(soundHistory) {}

    bool isTuningFile(const std::filesystem::path& file) const override {
        return matches(file, tuningFiles);
    }
    std::string tuningPatterns() const override { return tuningFiles; }
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

    SharedParts& shared;
    SoundSession& session;
    SoundHistory& history;
    ScalaTuning scala; ///< under the session's lock
};

} // namespace idiophone
