#include "Plugin/OutputBuses.h"

#include <algorithm>

namespace idiophone {

void OutputBuses::prepare(double sampleRateHz, OutputSet outputs) {
    connected = outputs;
    connected.set(0);
    hasSounded = 1;
    // Blocks are rendered in pieces of our own size, because the host's blocks may have any size.
    for (std::size_t output = 0; output < maximumOutputs; ++output)
        if (connected[output])
            stages[output].prepare(sampleRateHz, BlockPieces::maximumSamples);
}

void OutputBuses::reset() noexcept {
    hasSounded = 1;
    for (std::size_t output = 0; output < maximumOutputs; ++output)
        if (connected[output])
            stages[output].reset();
}

/// The levels of all stages follow the same values, so the main one speaks for all.
float OutputBuses::changeSound(const ParameterValues& values, double fadeSeconds) noexcept {
    for (std::size_t output = 1; output < maximumOutputs; ++output)
        if (connected[output])
            stages[output].changeSound(values, fadeSeconds);
    return stages.front().changeSound(values, fadeSeconds);
}

void OutputBuses::hush(std::size_t unanswered) noexcept {
    for (std::size_t output = 0; output < maximumOutputs; ++output)
        if (connected[output])
            stages[output].hush(unanswered);
}

bool OutputBuses::silent() const noexcept {
    for (std::size_t output = 0; output < maximumOutputs; ++output)
        if (connected[output] && !stages[output].silent())
            return false;
    return true;
}

bool OutputBuses::process(std::span<const StereoSpan> sounds,
                          const Channels& channels,
                          const ParameterValues& values) noexcept {
    const auto isSilent = [](float sample) { return sample == 0; };
    const auto count = sounds.front().size();
    bool isFinite = true;
    for (std::size_t output = 0; output < maximumOutputs; ++output) {
        const auto& [left, right] = sounds[output];
        if (connected[output] && !hasSounded[output]) {
            hasSounded[output] =
                !std::ranges::all_of(left, isSilent) || !std::ranges::all_of(right, isSilent);
            if (!hasSounded[output])
                stages[output].skip(count);
        }
        if (!hasSounded[output])
            for (float* channel : channels[output])
                std::fill_n(channel, count, 0.0f);
        else if (!stages[output].process(left, right, channels[output], values))
            isFinite = false;
    }
    return isFinite;
}

std::span<const float* const> OutputBuses::sum(const Channels& channels,
                                               std::size_t count) noexcept {
    const auto& main = channels.front();
    std::ranges::copy(main, summedChannels.begin());
    for (std::size_t output = 1; output < maximumOutputs; ++output) {
        const auto& added = channels[output];
        if (!connected[output] || added.empty())
            continue;
        for (std::size_t channel = 0; channel < main.size(); ++channel) {
            const float* const before = summedChannels[channel];
            const float* const left = added[main.size() > 1 ? channel : 0];
            const float* const right = added[main.size() > 1 ? channel : added.size() - 1];
            for (std::size_t k = 0; k < count; ++k)
                summed[channel][k] = before[k] + (left[k] + right[k]) / 2;
            summedChannels[channel] = summed[channel].data();
        }
    }
    return std::span(summedChannels).first(main.size());
}

} // namespace idiophone
