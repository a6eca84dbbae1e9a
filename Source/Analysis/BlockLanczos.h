// The modes nearest to a shift, by shift-invert Lanczos on blocks of vectors. Internal to Analysis:
// Eigensolver decides on shifts, and proves that none is missing.
#pragma once

#include "Analysis/MassSpace.h"
#include "Analysis/ShiftedFactor.h"

#include <Eigen/Core>
#include <functional>

namespace idiophone {

struct EigenBlock {
    Eigen::VectorXd values; ///< λ in rad²/s², ascending
    Vectors vectors;        ///< [n×count], M-orthonormal
};

struct LanczosTask {
    double low = 0, high = 0;   ///< λ asked for, the shift at or between them
    Eigen::Index wanted = 0;    ///< stops when so many have converged
    unsigned seed = 1;          ///< of the starting block
    std::function<void()> step; ///< called after each block of solves; may throw
};

/// The converged eigenpairs of (K − σM)⁻¹M between `low` and `high` that are M-orthogonal to
/// `found` (columns M-orthonormal). Usually all that are wanted; fewer where modes have more copies
/// than a block has columns, or the basis grew to three times their number: call again with those
/// added to `found`. The block Lanczos process (Golub & Underwood 1977; with shifts, Grimes, Lewis
/// & Simon 1994), each block orthogonalised against all before it, in products of matrices.
EigenBlock nearestModes(const ShiftedFactor& factor,
                        const MassSpace& space,
                        const Vectors& found,
                        const LanczosTask& task);

/// The number of vectors that `nearestModes` may keep.
Eigen::Index largestBasis(Eigen::Index wanted);

/// The same numbers between −½ and ½ on every machine.
Vectors fixedRandomBlock(Eigen::Index rows, Eigen::Index columns, unsigned seed);

} // namespace idiophone
