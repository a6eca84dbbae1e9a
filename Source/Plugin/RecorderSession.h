// Writes the output to sound files for the window.
#pragma once

#include "Editor/RecorderView.h"
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
    std::string newName() const override;

private:
    RollingSound::Piece heard() const;

    SoundSession& session;
    LastSound& lastSound;
};

} // namespace idiophone
