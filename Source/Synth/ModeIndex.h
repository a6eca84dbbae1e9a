// Converts numbers of modes and blocks, which are stored in 32 bits, to array indices.
#pragma once

#include <cstddef>
#include <cstdint>

namespace idiophone {

/// `number` is not negative.
constexpr std::size_t index(std::int32_t number) noexcept {
    return static_cast<std::size_t>(number);
}

} // namespace idiophone
