// The phrase by which the loudness of presets is judged, and what libebur128 measures of it.
#pragma once

#include "Instrument/Preset.h"
#include "Support/RenderNotes.h"

#include <ebur128.h>
#include <span>
#include <vector>

namespace idiophone::test {

/// Eight notes spread over the keys, two a second, at one velocity.
inline std::vector<MidiEvent> loudnessPhrase(const KeyMap& map, int velocity, double sampleRateHz) {
    std::vector<MidiEvent> events;
    for (int i = 0; i < 8; ++i) {
        const int note = map.lowestNote + (map.highestNote - map.lowestNote) * i / 7;
        const int time = static_cast<int>(i * sampleRateHz / 2);
        events.push_back(midi(time, 0x90, note, velocity));
        events.push_back(midi(time + static_cast<int>(sampleRateHz / 2) - 100, 0x80, note, 0));
    }
    return events;
}

/// The gated loudness of EBU R 128 of the whole sound.
inline double
integratedLufs(std::span<const float> interleaved, unsigned channels, double sampleRateHz) {
    auto* meter = ebur128_init(channels, static_cast<unsigned long>(sampleRateHz), EBUR128_MODE_I);
    ebur128_add_frames_float(meter, interleaved.data(), interleaved.size() / channels);
    double result = 0;
    ebur128_loudness_global(meter, &result);
    ebur128_destroy(&meter);
    return result;
}

} // namespace idiophone::test
