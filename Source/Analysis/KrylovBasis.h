// The growing set of vectors that a Lanczos process keeps. Internal to Analysis.
#pragma once

#include "Analysis/MassSpace.h"

#include <vector>

namespace idiophone {

/// M-orthonormal blocks of vectors [n×w], each in memory of its own so that none moves as more
/// come.
class KrylovBasis {
public:
    Eigen::Index size() const { return size_; } ///< in vectors
    const Vectors& last() const { return blocks_.back(); }

    void append(Vectors block);

    /// Subtracts from the columns of `block` their parts within the basis, given M times them.
    void projectOut(const Vectors& image, Vectors& block) const;

    /// The vectors with these coefficients [size×m].
    Vectors combinations(const Vectors& coefficients) const;

private:
    std::vector<Vectors> blocks_;
    Eigen::Index size_ = 0;
};

} // namespace idiophone
