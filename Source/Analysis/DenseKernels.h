// Products of small dense matrices with tall ones, for the instruction set of this machine.
// Internal to Analysis; for everything wider than a few columns or less hot, Eigen's own products.
#pragma once

#include <cstddef>

namespace idiophone {

/// One set for each instruction set that the program was compiled for. B and C are stored by rows.
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

/// The best set that this processor runs, always the same one.
const DenseKernels& denseKernels();

} // namespace idiophone
