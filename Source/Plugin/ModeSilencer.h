// Which modes are not to be heard, from the window to the audio thread.
#pragma once

#include "Instrument/Player.h"
#include "Instrument/SilencedModes.h"
#include "Plugin/Handoff.h"

#include <memory>

namespace idiophone {

class ModeSilencer {
public:
    /// [message side, one at a time] Holds for players of this instrument from their next callback
    /// on, and replaces what was sent before.
    void send(const Instrument& instrument, SilencedModes silenced) {
        handoff.publish(std::make_unique<Silences>(&instrument, std::move(silenced)));
    }

    /// [audio thread] Gives what was sent last to the player; what is meant for another instrument,
    /// which has gone since, is dropped. Neither allocates, locks nor throws.
    void silence(Player* player) noexcept {
        Silences* const sent = handoff.take();
        if (sent == nullptr)
            return;
        if (player != nullptr && &player->instrument() == sent->instrument)
            player->setSilencedModes(sent->modes);
        handoff.retire(sent);
    }

private:
    struct Silences {
        Silences(const Instrument* of, SilencedModes silenced)
            : instrument(of), modes(std::move(silenced)) {}

        const Instrument* instrument; ///< compared, never read
        SilencedModes modes;
    };

    Handoff<Silences> handoff;
};

} // namespace idiophone
