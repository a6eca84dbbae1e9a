// The inner loop of synthesis: adds what many modes sound to a buffer and takes their states on.
// Nothing else renders modes, so that a faster kernel replaces this one file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace idiophone {

inline constexpr std::size_t subBlockSamples = 16;

/// Contiguous arrays over G modes (groups of merged modes). Block form: within a sub-block mode g
/// sounds v[k] = table[32g + k] x + table[32g + 16 + k] y.
struct ModalBankArrays {
    const float* tables; ///< [G,2,16] first row of the propagator to sample k: Re ρᵏ, −Im ρᵏ
    const double* steps; ///< [G,2,2] propagator over one sub-block, row-major
    double* states;      ///< [G,2] x, y; kept in double so that the phase holds for hours
};

/// Adds modes `active` to `output` (a multiple of 16 samples) and advances their states by as much.
/// Audio thread.
void renderModalBank(const ModalBankArrays& bank,
                     std::span<const std::int32_t> active,
                     std::span<float> output) noexcept;

} // namespace idiophone
