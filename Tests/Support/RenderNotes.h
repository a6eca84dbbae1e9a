// Renders MIDI events through a player in blocks of one size.
#pragma once

#include "Instrument/Player.h"

#include <algorithm>
#include <vector>

namespace idiophone::test {

inline MidiEvent midi(int sample, int status, int first, int second) {
    return {.sampleOffset = sample,
            .bytes = {static_cast<std::uint8_t>(status), static_cast<std::uint8_t>(first),
                      static_cast<std::uint8_t>(second)}};
}

struct StereoSound {
    std::vector<float> left, right;

    explicit StereoSound(std::size_t samples) : left(samples), right(samples) {}
    operator StereoSpan() { return {left, right}; }
    bool operator==(const StereoSound&) const = default;
};

/// Renders stereo; `events` are in order, with times from the start of the stream. The input is as
/// long as the output, or empty.
inline StereoSound renderStereo(Player& player,
                                const std::vector<MidiEvent>& events,
                                std::size_t samples,
                                std::size_t blockSize,
                                const ParameterValues& parameters = {},
                                std::span<const float> input = {}) {
    StereoSound output(samples);
    std::size_t next = 0;
    for (std::size_t start = 0; start < samples; start += blockSize) {
        const auto count = std::min(blockSize, samples - start);
        std::vector<MidiEvent> block;
        for (; next < events.size() &&
               static_cast<std::size_t>(events[next].sampleOffset) < start + count;
             ++next) {
            block.push_back(events[next]);
            block.back().sampleOffset -= static_cast<int>(start);
        }
        player.process(StereoSpan(output).subspan(start, count), block, parameters,
                       input.empty() ? input : input.subspan(start, count));
    }
    return output;
}

/// Renders the mean of both channels.
inline std::vector<float> render(Player& player,
                                 const std::vector<MidiEvent>& events,
                                 std::size_t samples,
                                 std::size_t blockSize,
                                 const ParameterValues& parameters = {}) {
    auto output = renderStereo(player, events, samples, blockSize, parameters);
    for (std::size_t i = 0; i < samples; ++i)
        output.left[i] = (output.left[i] + output.right[i]) / 2;
    return output.left;
}

} // namespace idiophone::test
