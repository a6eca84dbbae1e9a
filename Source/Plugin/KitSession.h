// Shows the parts of a kit to the window, and edits them.
#pragma once

#include "Editor/KitView.h"
#include "Plugin/SoundHistory.h"
#include "Plugin/SoundSession.h"

#include <string>

namespace idiophone {

/// For the message thread.
class KitSession final : public KitView {
public:
    KitSession(SharedParts& sharedParts, SoundSession& soundSession, SoundHistory& soundHistory)
        : shared(sharedParts), session(soundSession), history(soundHistory) {}

    std::vector<Part> kitParts() const override;
    Result<void> canBeKit() const override;
    void makeKit() override;
    void changePart(std::size_t part, const Part& wanted) override;
    void removePart(std::size_t part) override;

private:
    void play(const SoundSession::Loaded& now,
              const Result<Sound>& wanted,
              const std::string& step,
              const std::string& refusal);

    SharedParts& shared;
    SoundSession& session;
    SoundHistory& history;
};

} // namespace idiophone
