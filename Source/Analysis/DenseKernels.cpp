#include "Analysis/DenseKernels.h"

#include "Analysis/DenseKernelsBody.h"

namespace idiophone {

#ifdef IDIOPHONE_AVX2_KERNELS
void addProductAvx2(const DenseProduct& product);
#endif

void addProduct(const DenseProduct& product) {
#ifdef IDIOPHONE_AVX2_KERNELS
    static const bool hasAvx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (hasAvx2)
        return addProductAvx2(product);
#endif
    kernels::addProduct(product);
}

} // namespace idiophone
