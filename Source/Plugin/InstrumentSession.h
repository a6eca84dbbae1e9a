// Shows the loaded instrument to the window, and passes on what the user plays there.
#pragma once

#include "Editor/InstrumentView.h"
#include "Plugin/SoundSession.h"
#include "Plugin/SurfaceHand.h"

#include <cstdint>

namespace idiophone {

/// For the message thread.
class InstrumentSession final : public InstrumentView {
public:
    InstrumentSession(SharedParts& shared, SoundSession& soundSession)
        : session(soundSession), events(shared.messages.window), report(shared.report),
          hand(events) {}

    int instrumentNumber() const override { return session.number(); }
    KeyRange keyRange() const override;
    std::array<KeySound, 128> keySounds() const override;
    std::vector<PlayedObject> playedObjects() const override;
    std::vector<std::array<double, 3>> struckPlaces(std::size_t index) const override;
    bool isFreeToPlay() const override { return isProcessing() && !report.songPlays; }
    void silence() override { events.silence(); }
    void playNote(int midiNote, int velocity) override;
    void strikeObject(std::size_t index,
                      const std::array<double, 3>& pointMetres,
                      int velocity) override;
    void scrapeObject(std::size_t index,
                      const std::array<double, 3>& pointMetres,
                      double pressure) override;

    /// Returns whether the host calls the engine. Some hosts stop in silence. Then strikes are
    /// refused with a sentence in the status line: all would wait and sound at once when the host
    /// goes on. Needs regular calls of `poll`.
    bool isProcessing() const;
    void poll();

private:
    bool takesStrikes();

    SoundSession& session;
    WindowEvents& events;
    const EngineReport& report;
    SurfaceHand hand;
    std::uint32_t callbacksSeen = 0, lastCallbackMilliseconds = 0;
    bool hasRefused = false; ///< since the last callback
};

} // namespace idiophone
