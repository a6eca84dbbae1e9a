// Shows the modes that sound to the window, and mutes or solos them.
#pragma once

#include "Editor/SoundView.h"
#include "Plugin/SoundHistory.h"
#include "Plugin/SoundPicture.h"
#include "Plugin/SoundSession.h"

#include <functional>
#include <string>

namespace idiophone {

/// For the message thread.
class ModeSession final : public SoundView {
public:
    ModeSession(SharedParts& sharedParts, SoundSession& soundSession, SoundHistory& soundHistory)
        : shared(sharedParts), session(soundSession), history(soundHistory) {}

    const SoundFrame* takeSoundFrame() override;
    void watchObject(std::optional<std::size_t> object) override;
    std::optional<std::size_t> watchedObject() const override { return watched; }
    bool muteMode(std::size_t object, std::int32_t mode, bool isMuted) override;
    bool hearModeAlone(std::size_t object, std::int32_t mode, bool isAlone) override;
    void unmuteModes(std::size_t object) override;
    void hearAllModes(std::size_t object) override;

private:
    /// Changes the modes of an object, by its key in mode sets and its number of modes. Returns
    /// whether any mode changed.
    using Change = std::function<bool(const std::string& key, std::size_t modeCount)>;
    bool change(std::size_t object, const Change& changeModes);
    bool record(const std::string& step, std::size_t object, const Change& changeModes);

    SharedParts& shared;
    SoundSession& session;
    SoundHistory& history;
    SoundPicture picture;
    int asksUnanswered = 0;
    std::optional<std::size_t> watched; ///< index of the object that the window watches
    int watchedInstrument = 0;
};

} // namespace idiophone
