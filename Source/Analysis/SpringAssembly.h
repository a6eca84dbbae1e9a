// Collects linearised springs into a stiffness matrix. Internal to Analysis.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <vector>

namespace idiophone {

/// Adds rank-one stiffnesses k g gᵀ. gᵀu is an elongation, or a difference of elongations, of the
/// displacements of `Points` points. A spring has g = (n, −n).
class SpringAssembly {
public:
    using Triplet = Eigen::Triplet<double>;

    void reserve(std::size_t entries) { triplets_.reserve(entries); }

    /// `firstRows` are the rows of the points' x displacements.
    template <std::size_t Points>
    void add(double stiffness,
             const std::array<int, Points>& firstRows,
             const std::array<Eigen::Vector3d, Points>& gradients) {
        for (std::size_t p = 0; p < Points; ++p)
            for (std::size_t q = 0; q < Points; ++q) {
                if (firstRows[p] < firstRows[q])
                    continue;
                const Eigen::Matrix3d block = stiffness * gradients[p] * gradients[q].transpose();
                for (int i = 0; i < 3; ++i)
                    for (int j = 0; j < (p == q ? i + 1 : 3); ++j)
                        triplets_.emplace_back(firstRows[p] + i, firstRows[q] + j, block(i, j));
            }
    }

    /// Returns the lower triangle.
    Eigen::SparseMatrix<double> matrix(Eigen::Index rows) const {
        Eigen::SparseMatrix<double> result(rows, rows);
        result.setFromTriplets(triplets_.begin(), triplets_.end());
        return result;
    }

private:
    std::vector<Triplet> triplets_;
};

} // namespace idiophone
