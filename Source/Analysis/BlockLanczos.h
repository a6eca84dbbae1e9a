// The modes nearest to a shift, by shift-invert Lanczos on blocks of vectors. Internal to Analysis:
// Eigensolver chooses the shifts and proves that no mode is missing.
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
    double low = 0, high = 0;   ///< range of λ; the shift lies inside or on its edge
    Eigen::Index wanted = 0;    ///< number of modes after which the search stops
    unsigned seed = 1;          ///< seed of the starting block
    std::function<void()> step; ///< called after each block of solves; may throw
};

/// Returns converged eigenpairs of (K − σM)⁻¹M between `low` and `high`, M-orthogonal to `found`
/// (columns M-orthonormal). Usually it returns all wanted pairs. It returns fewer if a mode has
/// more copies than a block has columns, or if the basis reaches its maximum. Then call again with
/// the new pairs added to `found`. The method is block Lanczos (Golub & Underwood 1977; with
/// shifts, Grimes, Lewis & Simon 1994). Each block is orthogonalised against all earlier ones by
/// matrix products.
EigenBlock nearestModes(const ShiftedFactor& factor,
                        const MassSpace& space,
                        const Vectors& found,
                        const LanczosTask& task);

/// The maximum number of vectors in the basis of `nearestModes`.
Eigen::Index largestBasis(Eigen::Index wanted);

/// Returns pseudo-random numbers between −½ and ½, identical on every machine.
Vectors fixedRandomBlock(Eigen::Index rows, Eigen::Index columns, unsigned seed);

} // namespace idiophone
