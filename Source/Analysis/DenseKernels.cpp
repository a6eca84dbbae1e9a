#include "Analysis/DenseKernels.h"

#include "Analysis/DenseKernelsBody.h"

namespace idiophone {

#ifdef IDIOPHONE_AVX2_KERNELS
extern const DenseKernels denseKernelsAvx2;
#endif

namespace {

constexpr DenseKernels baseline{.addProduct = kernels::addProduct};

const DenseKernels& choose() {
#ifdef IDIOPHONE_AVX2_KERNELS
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return denseKernelsAvx2;
#endif
    return baseline;
}

} // namespace

const DenseKernels& denseKernels() {
    static const DenseKernels& chosen = choose();
    return chosen;
}

} // namespace idiophone
