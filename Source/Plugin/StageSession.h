// Shows a stage to the window, pauses and resets it, and writes the impacts of its bodies.
#pragma once

#include "Editor/StageView.h"
#include "Plugin/SoundSession.h"

namespace idiophone {

/// For the message thread.
class StageSession final : public StageView {
public:
    StageSession(SharedParts& shared, SoundSession& soundSession)
        : session(soundSession), messages(shared.messages), report(shared.report) {}

    bool hasStage() const override;
    std::vector<BodyNow> stageBodies() const override;
    void pauseStage(bool isPaused) override { messages.stagePaused = isPaused; }
    bool isStagePaused() const override { return messages.stagePaused; }
    void resetStage() override;
    bool hasCaptured() override;
    bool writeCapture(CaptureKind kind, const std::filesystem::path& file) override;

private:
    StageCapture& capture();

    SoundSession& session;
    EngineMessages& messages;
    EngineReport& report;
};

} // namespace idiophone
