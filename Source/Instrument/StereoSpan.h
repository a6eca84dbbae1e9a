// The two channels of a block of sound, and the stereo outputs that a player has.
#pragma once

#include <bitset>
#include <cstddef>
#include <span>

namespace idiophone {

struct StereoSpan {
    std::span<float> left, right; ///< equal lengths

    std::size_t size() const { return left.size(); }
    StereoSpan subspan(std::size_t offset, std::size_t count) const {
        return {left.subspan(offset, count), right.subspan(offset, count)};
    }
};

/// The main output, which is the first, and seven more.
inline constexpr std::size_t maximumOutputs = 8;
/// Has a bit for each output.
using OutputSet = std::bitset<maximumOutputs>;

/// Returns which outputs are connected. The others have no samples, not even an address.
inline OutputSet connectedOutputs(std::span<const StereoSpan> outputs) {
    OutputSet connected;
    for (std::size_t output = 0; output < outputs.size(); ++output)
        connected[output] = outputs[output].left.data() != nullptr;
    return connected;
}

} // namespace idiophone
