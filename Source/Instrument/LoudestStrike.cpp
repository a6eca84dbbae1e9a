#include "Instrument/LoudestStrike.h"

#include "Instrument/Player.h"
#include "Instrument/SpreadNotes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace idiophone {

double loudestStrikePeak(const std::shared_ptr<const Instrument>& instrument,
                         const Surface& surface,
                         double sampleRateHz,
                         const ParameterValues& parameters) {
    constexpr int keys = 8;
    constexpr double heardSeconds = 0.05;
    Player player(instrument, sampleRateHz, surface, 1, parameters);
    std::vector<float> left(static_cast<std::size_t>(std::ceil(heardSeconds * sampleRateHz)));
    std::vector<float> right(left.size());
    const auto& map = instrument->keyMap();
    double peak = 0;
    for (int i = 0; i < keys; ++i) {
        const int note = spreadNote(map.lowestNote, map.highestNote, i, keys);
        player.reset();
        player.prepare(parameters);
        player.process({left, right},
                       std::array{MidiEvent{.sampleOffset = 0,
                                            .bytes = {0x90, static_cast<std::uint8_t>(note), 127}}},
                       parameters);
        for (const auto* channel : {&left, &right})
            for (const float sample : *channel)
                peak = std::max(peak, static_cast<double>(std::abs(sample)));
    }
    return peak;
}

} // namespace idiophone
