// Hands the set of silenced modes from the window to the audio thread.
#pragma once

#include "Instrument/Player.h"
#include "Instrument/SilencedModes.h"
#include "Plugin/Handoff.h"

#include <cstdint>
#include <memory>

namespace idiophone {

class ModeSilencer {
public:
    /// [message side, one at a time] Applies to players of this instrument from their next callback
    /// on. Replaces the set sent before.
    void send(const Instrument& instrument, SilencedModes silenced) {
        handoff.publish(std::make_unique<Silences>(instrument.serialNumber(), std::move(silenced)));
    }

    /// [audio thread] Gives the last set to the player. Drops a set for another instrument. Neither
    /// allocates, locks nor throws.
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
