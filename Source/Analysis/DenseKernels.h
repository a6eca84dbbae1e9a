// Products of small dense matrices with tall ones, for this machine's instruction set. Internal to
// Analysis. Eigen computes other products, which are wide or rarely used.
#pragma once

#include <cstddef>

namespace idiophone {

/// One set for each instruction set in the program. B and C are stored by rows.
struct DenseKernels {
    using Index = std::ptrdiff_t;

    /// C[rows×columns] += factor · A[rows×inner] · B[inner×columns]. The strides are the distances
    /// from row to row, and for A also from column to column, in doubles.
    void (*addProduct)(Index rows,
                       Index columns,
                       Index inner,
                       double factor,
                       const double* a,
                       Index aRow,
                       Index aColumn,
                       const double* b,
                       Index bRow,
                       double* c,
                       Index cRow);
};

/// Returns the best set for this processor, always the same one.
const DenseKernels& denseKernels();

} // namespace idiophone
