// The growing basis of a Lanczos process. Internal to Analysis.
#pragma once

#include "Analysis/MassSpace.h"

#include <vector>

namespace idiophone {

class WorkTeam;

/// M-orthonormal blocks of vectors [n×w]. Each has its own memory, so that appending moves none.
class KrylovBasis {
public:
    /// The team outlives it. It may be null, with the same result.
    explicit KrylovBasis(WorkTeam* team = nullptr) : team_(team) {}

    Eigen::Index size() const { return size_; } ///< in vectors
    const Vectors& last() const { return blocks_.back(); }

    void append(Vectors block);

    /// Subtracts from the columns of `block` their parts within the basis. `image` is M times
    /// `block`.
    void projectOut(const Vectors& image, Vectors& block) const;

    /// Returns the combinations with these coefficients [size×m].
    Vectors combinations(const Vectors& coefficients) const;

private:
    void addTo(Vectors& sums, double factor, const Vectors& coefficients) const;

    WorkTeam* team_;
    std::vector<Vectors> blocks_;
    Eigen::Index size_ = 0;
};

} // namespace idiophone
