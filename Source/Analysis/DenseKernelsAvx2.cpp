// DenseKernels compiled for AVX2 and FMA. Only processors that have both may call it.
#define Eigen EigenAvx2
#define kernels kernelsAvx2
#include "Analysis/DenseKernelsBody.h"

namespace idiophone {

void addProductAvx2(const DenseProduct& product) {
    kernels::addProduct(product);
}

} // namespace idiophone
