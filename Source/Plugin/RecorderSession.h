// Writes the output to sound files for the window.
#pragma once

#include "Editor/RecorderView.h"
#include "Plugin/SoundRecorder.h"
#include "Plugin/SoundSession.h"

namespace idiophone {

/// For the message thread.
class RecorderSession final : public RecorderView {
public:
    RecorderSession(SharedParts& shared, SoundSession& soundSession)
        : session(soundSession), lastSound(shared.report.lastSound) {}

    void keepLastSound() override { lastSound.keep(); }
    bool hasLastSound() const override { return !heard().left.empty(); }
    bool writeLastSound(const std::filesystem::path& file) override;
    void startRecording() override;
    void stopRecording() override;
    Recording recording() const override { return recorder.state(); }
    std::string newName() const override;

    /// Call it regularly. Reports a recording that ended by itself.
    void poll();

private:
    RollingSound::Piece heard() const;

    SoundSession& session;
    LastSound& lastSound;
    SoundRecorder recorder; ///< completes its file when the processor ends
};

} // namespace idiophone
