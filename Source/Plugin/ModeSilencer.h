// Hands the set of silenced modes from the window to the audio thread.
#pragma once

#include "Instrument/LatestValue.h"
#include "Instrument/Player.h"
#include "Instrument/SilencedModes.h"

#include <cstdint>

namespace idiophone {

class ModeSilencer {
public:
    /// [message side, one at a time] Applies to players of this instrument from their next callback
    /// on. Replaces the set sent before.
    void send(const Instrument& instrument, SilencedModes silenced) {
        latest.next() = {.instrument = instrument.serialNumber(), .modes = std::move(silenced)};
        latest.publish();
    }

    /// [audio thread] Gives the last set to the player. Drops a set for another instrument. Neither
    /// allocates, locks nor throws.
    void silence(Player* player) noexcept {
        const auto* sent = latest.take();
        if (sent != nullptr && player != nullptr &&
            player->instrument().serialNumber() == sent->instrument)
            player->setSilencedModes(sent->modes);
    }

private:
    struct Silences {
        std::uint64_t instrument = 0; ///< its serial number
        SilencedModes modes;
    };

    LatestValue<Silences> latest{Silences{}};
};

} // namespace idiophone
