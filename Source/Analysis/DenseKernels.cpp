#include "Analysis/DenseKernels.h"

#include "Analysis/DenseKernelsBody.h"

namespace idiophone {

#ifdef IDIOPHONE_AVX2_KERNELS
void addProductAvx2(const DenseProduct& product);
void addProductAvx512(const DenseProduct& product);
#endif

void addProduct(const DenseProduct& product) {
#ifdef IDIOPHONE_AVX2_KERNELS
    static const bool hasAvx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    static const bool hasAvx512 = hasAvx2 && __builtin_cpu_supports("avx512f");
    DenseProduct rest = product;
    if (const auto wide = product.columns / 8 * 8; hasAvx512 && wide > 0) {
        rest.columns = wide;
        addProductAvx512(rest);
        rest.columns = product.columns - wide;
        rest.b += wide;
        rest.c += wide;
    }
    if (hasAvx2) {
        if (rest.columns > 0)
            addProductAvx2(rest);
        return;
    }
#endif
    kernels::addProduct(product);
}

} // namespace idiophone
