// Which modes are not to be heard, from the window to the audio thread.
#pragma once

#include "Instrument/Player.h"
#include "Instrument/SilencedModes.h"
#include "Plugin/Handoff.h"

#include <cstdint>
#include <memory>

namespace idiophone {

class ModeSilencer {
public:
    /// [message side, one at a time] Holds for players of this instrument from their next callback
    /// on, and replaces what was sent before.
    void send(const Instrument& instrument, SilencedModes silenced) {
        handoff.publish(std::make_unique<Silences>(instrument.serialNumber(), std::move(silenced)));
    }

    /// [audio thread] Gives what was sent last to the player; what is meant for another instrument,
    /// which has gone since, is dropped. Neither allocates, locks nor throws.
    void silence(Player* player) noexcept {
        Silences* const sent = handoff.take();
        if (sent == nullptr)
            return;
        if (player != nullptr && player->instrument().serialNumber() == sent->instrument)
            player->setSilencedModes(sent->modes);
        handoff.retire(sent);
    }

private:
    struct Silences {
        Silences(std::uint64_t of, SilencedModes silenced)
            : instrument(of), modes(std::move(silenced)) {}

        std::uint64_t instrument; ///< its serial number
        SilencedModes modes;
    };

    Handoff<Silences> handoff;
};

} // namespace idiophone
