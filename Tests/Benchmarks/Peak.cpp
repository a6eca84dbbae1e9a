#include "Benchmarks/Peak.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Benchmarks/Peak.cpp"
#include <hwy/foreach_target.h> // compiles this file once for each target

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace idiophone {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// This is more than latency times ports of any core, and fewer than AVX2's 16 registers.
constexpr std::size_t accumulators = 12;

using Floats = hn::CappedTag<float, 16>;

float multiplyAdds(std::size_t steps, float seed) {
    const Floats f;
    // The factor and summand keep the sums near 1, without overflow or denormals.
    const auto factor = hn::Set(f, 1 - 0x1p-10f * seed);
    const auto summand = hn::Set(f, 0x1p-10f);
    hn::Vec<Floats> sums[accumulators];
#pragma GCC unroll 16
    for (std::size_t k = 0; k < accumulators; ++k)
        sums[k] = hn::Set(f, seed + static_cast<float>(k));
    for (std::size_t step = 0; step < steps; ++step)
#pragma GCC unroll 16
        for (std::size_t k = 0; k < accumulators; ++k)
            sums[k] = hn::MulAdd(sums[k], factor, summand);
    auto total = sums[0];
#pragma GCC unroll 16
    for (std::size_t k = 1; k < accumulators; ++k)
        total = hn::Add(total, sums[k]);
    return hn::GetLane(hn::SumOfLanes(f, total));
}

std::size_t multiplyAddsPerStep() {
    return accumulators * hn::Lanes(Floats());
}

const char* targetName() {
    return hwy::TargetName(HWY_TARGET);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace idiophone
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace idiophone {

HWY_EXPORT(multiplyAdds);
HWY_EXPORT(multiplyAddsPerStep);
HWY_EXPORT(targetName);

float fmaLoop(std::size_t steps, float seed) {
    return HWY_DYNAMIC_DISPATCH(multiplyAdds)(steps, seed);
}

std::size_t fmasPerStep() {
    return HWY_DYNAMIC_DISPATCH(multiplyAddsPerStep)();
}

std::string simdTarget() {
    return HWY_DYNAMIC_DISPATCH(targetName)();
}

} // namespace idiophone
#endif
