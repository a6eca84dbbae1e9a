// Numbers of modes and blocks, which are stored in 32 bits, as indices of arrays.
#pragma once

#include <cstddef>
#include <cstdint>

namespace idiophone {

/// Of a number that is not negative.
constexpr std::size_t index(std::int32_t number) noexcept {
    return static_cast<std::size_t>(number);
}

} // namespace idiophone
