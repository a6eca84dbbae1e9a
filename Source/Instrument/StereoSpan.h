// The two channels of a block of sound.
#pragma once

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

} // namespace idiophone
