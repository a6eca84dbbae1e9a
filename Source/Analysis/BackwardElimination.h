// Least squares with many candidate terms, from which the needless ones are removed one by one.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <vector>

namespace idiophone {

/// Several least-squares problems share their candidates. A candidate has `width` columns in each
/// problem. Its own energy in a problem is what the residual grows by if it is removed and all
/// others are fitted anew. So two candidates that stand for the same tone have little own energy,
/// until one of them is removed.
template <class Scalar, int width>
class BackwardElimination {
public:
    using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

    /// `gram` holds the products of all columns, which must not vanish, `right` those with the
    /// data.
    void add(const Matrix& gram, const Vector& right) {
        constexpr double smallestRidge = 1e-10, largestRidge = 1e-2; // candidates may coincide
        const Eigen::VectorXd scale = gram.diagonal().real().cwiseSqrt().cwiseInverse();
        const Matrix scaled = scale.asDiagonal() * gram * scale.asDiagonal();
        const Matrix identity = Matrix::Identity(scaled.rows(), scaled.cols());
        Eigen::LLT<Matrix> solver;
        for (double ridge = smallestRidge; ridge <= largestRidge; ridge *= 100) {
            solver.compute(scaled + ridge * identity);
            if (solver.info() == Eigen::Success)
                break;
        }
        const Matrix inverse = solver.solve(identity);
        problems.push_back(
            {.scale = scale, .inverse = inverse, .solution = inverse * scale.asDiagonal() * right});
        kept.assign(static_cast<std::size_t>(right.size() / width), true);
    }

    /// Removes the candidate with the least score until all scores are at least 1 and at most
    /// `maximum` candidates are left. A score is the sum of the own energies, each divided by
    /// its `floors` [candidates, problems].
    void run(const Eigen::MatrixXd& floors, Eigen::Index maximum) {
        auto left = static_cast<Eigen::Index>(std::count(kept.begin(), kept.end(), true));
        while (left > 0) {
            Eigen::Index least = 0;
            double leastScore = std::numeric_limits<double>::infinity();
            for (Eigen::Index i = 0; i < floors.rows(); ++i) {
                if (!kept[i])
                    continue;
                double score = 0;
                for (std::size_t p = 0; p < problems.size(); ++p)
                    score += ownEnergy(i, p) / floors(i, static_cast<Eigen::Index>(p));
                if (score < leastScore) {
                    leastScore = score;
                    least = i;
                }
            }
            if (leastScore >= 1 && left <= maximum)
                return;
            remove(least);
            --left;
        }
    }

    double ownEnergy(Eigen::Index candidate, std::size_t problem) const {
        const auto& [scale, inverse, solution] = problems[problem];
        const auto own = solution.template segment<width>(width * candidate);
        const Eigen::Matrix<Scalar, width, width> block =
            inverse.template block<width, width>(width * candidate, width * candidate);
        return std::abs(own.dot(block.inverse() * own));
    }

    /// The best factor of a column in a problem.
    Scalar factor(Eigen::Index column, std::size_t problem) const {
        return problems[problem].solution(column) * problems[problem].scale(column);
    }

    bool keeps(Eigen::Index candidate) const { return kept[static_cast<std::size_t>(candidate)]; }

private:
    struct Problem {
        Eigen::VectorXd scale; ///< makes the columns' norms 1
        Matrix inverse;
        Vector solution;
    };

    void remove(Eigen::Index candidate) {
        for (auto& problem : problems) {
            const Matrix columns = problem.inverse.template middleCols<width>(width * candidate);
            const Eigen::Matrix<Scalar, width, width> block =
                columns.template middleRows<width>(width * candidate);
            const Matrix share = columns * block.inverse();
            const Vector own = problem.solution.template segment<width>(width * candidate);
            problem.solution -= share * own;
            problem.inverse.noalias() -= share * columns.adjoint();
            problem.solution.template segment<width>(width * candidate).setZero();
        }
        kept[static_cast<std::size_t>(candidate)] = false;
    }

    std::vector<Problem> problems;
    std::vector<bool> kept;
};

} // namespace idiophone
