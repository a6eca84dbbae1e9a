// The most fused multiply-adds that one core can do: nothing but registers, on the widest vectors
// of the SIMD target that the synthesiser runs on. The measure of 100 %, not a kernel.
#pragma once

#include <cstddef>
#include <string>

namespace idiophone {

/// Runs `steps` times 12 independent vector multiply-adds from `seed` (0 to 1) and returns their
/// sum, which has to be used.
float fmaLoop(std::size_t steps, float seed);

/// Single-precision multiply-adds in one step, all lanes counted.
std::size_t fmasPerStep();

/// The SIMD target chosen at run time, as Highway names it: "AVX3", "AVX2", "SSE4", "NEON"...
std::string simdTarget();

} // namespace idiophone
