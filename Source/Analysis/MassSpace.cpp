#include "Analysis/MassSpace.h"

#include "Analysis/DenseKernels.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace idiophone {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index stripRows = 64; ///< rows of tall matrices per step, so that they stay cached

template <int width>
void addSymmetric(const Eigen::SparseMatrix<double>& lower, const Vectors& x, Vectors& y) {
    using Row = Eigen::Matrix<double, 1, width>;
    const Index w = x.cols();
    for (Index column = 0; column < lower.outerSize(); ++column) {
        const Row own = x.row(column);
        Row sum = Row::Zero(w);
        for (Eigen::SparseMatrix<double>::InnerIterator e(lower, column); e; ++e) {
            sum += e.value() * Eigen::Map<const Row>(x.data() + e.row() * w, w);
            if (e.row() != column)
                Eigen::Map<Row>(y.data() + e.row() * w, w) += e.value() * own;
        }
        Eigen::Map<Row>(y.data() + column * w, w) += sum;
    }
}

} // namespace

Vectors innerProducts(const Vectors& a, const Vectors& b) {
    Vectors c = Vectors::Zero(a.cols(), b.cols());
    for (Index row = 0; row < a.rows(); row += stripRows)
        addProduct({a.cols(), b.cols(), std::min(stripRows, a.rows() - row), 1,
                    a.data() + row * a.cols(), 1, a.cols(), b.data() + row * b.cols(), b.cols(),
                    c.data(), c.cols()});
    return c;
}

void addCombinations(Vectors& c, double factor, const Vectors& a, const Vectors& b) {
    for (Index row = 0; row < a.rows(); row += stripRows)
        addProduct({std::min(stripRows, a.rows() - row), b.cols(), a.cols(), factor,
                    a.data() + row * a.cols(), a.cols(), 1, b.data(), b.cols(),
                    c.data() + row * c.cols(), c.cols()});
}

Vectors symmetricTimes(const Eigen::SparseMatrix<double>& lower, const Vectors& x) {
    Vectors y = Vectors::Zero(x.rows(), x.cols());
    switch (x.cols()) {
    case 4:
        addSymmetric<4>(lower, x, y);
        break;
    case 6: // the number of rigid modes
        addSymmetric<6>(lower, x, y);
        break;
    case 8:
        addSymmetric<8>(lower, x, y);
        break;
    default:
        addSymmetric<Eigen::Dynamic>(lower, x, y);
    }
    return y;
}

void MassSpace::projectOut(const Vectors& basis, Vectors& block) const {
    if (basis.cols() > 0)
        addCombinations(block, -1, basis, innerProducts(basis, times(block)));
}

MatrixXd MassSpace::orthonormalise(Vectors& block, Vectors& image) const {
    // The Cholesky factor of the products loses digits if columns are nearly dependent, so run
    // twice.
    MatrixXd back = MatrixXd::Identity(block.cols(), block.cols());
    for (int pass = 0; pass < 2; ++pass) {
        image = times(block);
        const Vectors products = innerProducts(block, image);
        if (!products.allFinite() || !(products.diagonal().minCoeff() > 0))
            return {};
        const Eigen::VectorXd lengths = products.diagonal().cwiseSqrt();
        const auto inverse = lengths.cwiseInverse().asDiagonal();
        const Eigen::LLT<MatrixXd> cholesky(inverse * products * inverse);
        if (cholesky.info() != Eigen::Success)
            return {};
        const MatrixXd upper = MatrixXd(cholesky.matrixU()) * lengths.asDiagonal();
        const Vectors toNew = upper.triangularView<Eigen::Upper>().solve(
            MatrixXd::Identity(block.cols(), block.cols()));
        back = (upper * back).eval();
        // Nearly parallel columns lose digits. A second pass then starts from the vectors.
        const bool isSafe = upper.diagonal().cwiseQuotient(lengths).minCoeff() > 0.1;
        const auto change = [&](Vectors& vectors) {
            Vectors changed = Vectors::Zero(vectors.rows(), vectors.cols());
            addCombinations(changed, 1, vectors, toNew);
            vectors.swap(changed);
        };
        change(block);
        if (pass == 1 || isSafe) {
            change(image);
            return back;
        }
    }
    return back;
}

} // namespace idiophone
