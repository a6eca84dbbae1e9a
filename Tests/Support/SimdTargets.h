// Runs code with the kernels of every SIMD target of this machine, not only the best one.
#pragma once

#include <cstdint>
#include <hwy/highway.h>
#include <vector>

namespace idiophone::test {

#ifdef HWY_COMPILE_ONLY_STATIC // there is only one
struct TargetInTurn {
    explicit TargetInTurn(std::int64_t) {}
};

inline std::vector<std::int64_t> targetsHere() {
    return {HWY_STATIC_TARGET};
}
#else
/// While this object lives, dispatch uses this target. Afterwards it uses the best one.
struct TargetInTurn {
    explicit TargetInTurn(std::int64_t target) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
    ~TargetInTurn() {
        hwy::SetSupportedTargetsForTest(0);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
};

inline std::vector<std::int64_t> targetsHere() {
    std::vector<std::int64_t> targets;
    for (std::int64_t rest = hwy::SupportedTargets(); rest != 0; rest &= rest - 1)
        targets.push_back(rest & -rest);
    return targets;
}
#endif

} // namespace idiophone::test
