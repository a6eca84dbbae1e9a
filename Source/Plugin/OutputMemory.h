// Memory for a piece of sound on each output.
#pragma once

#include "Instrument/StereoSpan.h"
#include "Plugin/BlockPieces.h"

#include <array>
#include <span>

namespace idiophone {

class OutputMemory {
public:
    /// Returns the first `count` samples, at most `BlockPieces::maximumSamples`, of the connected
    /// outputs. The others have no memory. Valid until the next call.
    std::span<const StereoSpan> first(std::size_t count, OutputSet connected) noexcept {
        for (std::size_t output = 0; output < maximumOutputs; ++output) {
            auto& [left, right] = samples[output];
            spans[output] = connected[output] ? StereoSpan{std::span(left).first(count),
                                                           std::span(right).first(count)}
                                              : StereoSpan{};
        }
        return spans;
    }

private:
    using Channel = std::array<float, BlockPieces::maximumSamples>;

    std::array<std::array<Channel, 2>, maximumOutputs> samples{};
    std::array<StereoSpan, maximumOutputs> spans;
};

} // namespace idiophone
