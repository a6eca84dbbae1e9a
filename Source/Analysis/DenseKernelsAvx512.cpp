// DenseKernels compiled for AVX-512, for columns in groups of eight. Only processors that have it
// may call it.
#define Eigen EigenAvx512
#define kernels kernelsAvx512
#include "Analysis/DenseKernelsBody.h"

namespace idiophone {

void addProductAvx512(const DenseProduct& product) {
    kernels::addProduct(product);
}

} // namespace idiophone
