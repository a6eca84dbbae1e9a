// The maximum rate of fused multiply-adds on one core: registers only, on the widest vectors of the
// synthesiser's SIMD target. Benchmarks of kernels count this rate as 100 %.
#pragma once

#include <cstddef>
#include <string>

namespace idiophone {

/// Runs `steps` times 12 independent vector multiply-adds from `seed` (0 to 1). The caller must use
/// the sum that it returns.
float fmaLoop(std::size_t steps, float seed);

/// Returns the single-precision multiply-adds of one step in all lanes.
std::size_t fmasPerStep();

/// Returns Highway's name of the SIMD target selected at run time: "AVX3", "AVX2", "SSE4",
/// "NEON"...
std::string simdTarget();

} // namespace idiophone
