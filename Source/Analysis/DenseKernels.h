// Products of small dense matrices with tall ones, for this machine's instruction set. Internal to
// Analysis. Eigen computes other products, which are wide or rarely used.
#pragma once

#include <cstddef>

namespace idiophone {

/// C[rows×columns] += factor · A[rows×inner] · B[inner×columns]. B and C are stored by rows. The
/// strides are the distances from row to row, and for A also from column to column, in doubles.
struct DenseProduct {
    using Index = std::ptrdiff_t;

    Index rows, columns, inner;
    double factor;
    const double* a;
    Index aRow, aColumn;
    const double* b;
    Index bRow;
    double* c;
    Index cRow;
};

/// Adds the product with the best code for this processor, always the same. AVX2 and AVX-512 give
/// the same bits.
void addProduct(const DenseProduct& product);

} // namespace idiophone
