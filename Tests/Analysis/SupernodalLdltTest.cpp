#include "Analysis/SupernodalLdlt.h"

#include "Analysis/BlockLanczos.h"
#include "Object/WorkTeam.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

using namespace idiophone;
using Eigen::Index;
using Eigen::MatrixXd;

namespace {

const std::function<bool()> never = [] { return false; };

/// A lattice of `across` × `across` vertices with `blockSize` unknowns each. Neighbours, also
/// diagonal ones, couple by random numbers. `diagonal` is added to the diagonal.
Eigen::SparseMatrix<double> lattice(int across, int blockSize, double diagonal) {
    const Index n = Index{across} * across * blockSize;
    const Vectors random = fixedRandomBlock(n, 9 * blockSize, 3);
    std::vector<Eigen::Triplet<double>> entries;
    for (int x = 0; x < across; ++x)
        for (int y = 0; y < across; ++y)
            for (int nx = std::max(0, x - 1); nx <= std::min(across - 1, x + 1); ++nx)
                for (int ny = std::max(0, y - 1); ny <= std::min(across - 1, y + 1); ++ny)
                    for (int i = 0; i < blockSize; ++i)
                        for (int j = 0; j < blockSize; ++j) {
                            const Index row = (x * across + y) * blockSize + i;
                            const Index column = (nx * across + ny) * blockSize + j;
                            const int place = 3 * (nx - x + 1) + ny - y + 1;
                            if (row >= column)
                                entries.emplace_back(row, column,
                                                     random(row, place * blockSize + j) +
                                                         (row == column ? diagonal : 0));
                        }
    Eigen::SparseMatrix<double> lower(n, n);
    lower.setFromTriplets(entries.begin(), entries.end());
    return lower;
}

MatrixXd dense(const Eigen::SparseMatrix<double>& lower) {
    return MatrixXd(lower).selfadjointView<Eigen::Lower>();
}

} // namespace

TEST_CASE(
    "Solutions of an indefinite matrix match dense ones for all block sizes and right-hand sides") {
    const int blockSize = GENERATE(1, 2, 3, 4, 5, 6);
    const Index columns = GENERATE(1, 3, 4, 6, 8, 21);
    CAPTURE(blockSize, columns);
    const auto lower = lattice(11, blockSize, 0.5);
    SupernodalLdlt factor(lower, blockSize);
    REQUIRE(factor.factorise(lower, never) == LdltOutcome::done);
    const Vectors right = fixedRandomBlock(lower.rows(), columns, 5);
    Vectors x = right;
    factor.solve(x);
    const MatrixXd expected = dense(lower).partialPivLu().solve(MatrixXd(right));
    CHECK((MatrixXd(x) - expected).norm() < 1e-8 * expected.norm());
}

TEST_CASE("The number of negative pivots equals that of negative eigenvalues at every shift") {
    const int blockSize = GENERATE(1, 3, 6);
    const auto lower = lattice(9, blockSize, 0);
    const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<MatrixXd>(dense(lower), Eigen::EigenvaluesOnly).eigenvalues();
    SupernodalLdlt factor(lower, blockSize);
    for (const Index below : {Index{0}, values.size() / 3, values.size() / 2, values.size()}) {
        const double shift = below == 0               ? values(0) - 1
                             : below == values.size() ? values(below - 1) + 1
                                                      : (values(below - 1) + values(below)) / 2;
        Eigen::SparseMatrix<double> shifted = lower;
        shifted.diagonal().array() -= shift;
        REQUIRE(factor.factorise(shifted, never) == LdltOutcome::done);
        CHECK(factor.negativePivots() == below);
    }
}

TEST_CASE("Matrices with separate parts, and diagonal ones, are solved") {
    // Two unconnected lattices, and a diagonal.
    const auto one = lattice(5, 3, 20);
    const Index n = one.rows();
    Eigen::SparseMatrix<double> both(2 * n, 2 * n), diagonal(12, 12);
    std::vector<Eigen::Triplet<double>> entries;
    for (Index column = 0; column < n; ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator e(one, column); e; ++e)
            for (const Index start : {Index{0}, n})
                entries.emplace_back(e.row() + start, column + start, e.value());
    both.setFromTriplets(entries.begin(), entries.end());
    diagonal.setIdentity();
    diagonal *= -2;
    for (const auto* lower : {&both, &diagonal}) {
        SupernodalLdlt factor(*lower, 3);
        REQUIRE(factor.factorise(*lower, never) == LdltOutcome::done);
        Vectors x = Vectors::Ones(lower->rows(), 2);
        factor.solve(x);
        CHECK((dense(*lower) * x - MatrixXd::Ones(lower->rows(), 2)).norm() < 1e-10);
    }
    CHECK(SupernodalLdlt(diagonal, 3).entries() == 4 * 9 / 2.0);
}

TEST_CASE("An exact zero pivot is reported, and the next matrix is factorised as usual") {
    Eigen::SparseMatrix<double> zeros = lattice(6, 3, 10);
    const Eigen::SparseMatrix<double> regular = zeros;
    zeros *= 0;
    SupernodalLdlt factor(regular, 3);
    CHECK(factor.factorise(zeros, never) == LdltOutcome::singular);
    REQUIRE(factor.factorise(regular, never) == LdltOutcome::done);
    Vectors x = Vectors::Ones(regular.rows(), 1);
    factor.solve(x);
    CHECK((dense(regular) * x).isApproxToConstant(1, 1e-10));
}

TEST_CASE("A factorisation can be stopped at any time and repeated") {
    const auto lower = lattice(20, 3, 0.5);
    SupernodalLdlt factor(lower, 3);
    int asked = 0;
    REQUIRE(factor.factorise(lower, [&] {
        ++asked;
        return false;
    }) == LdltOutcome::done);
    REQUIRE(asked > 20);
    const auto negative = factor.negativePivots();
    for (const int last : {1, asked / 2, asked}) {
        int count = 0;
        CHECK(factor.factorise(lower, [&] { return ++count == last; }) == LdltOutcome::stopped);
        CHECK(count == last);
    }
    REQUIRE(factor.factorise(lower, never) == LdltOutcome::done);
    CHECK(factor.negativePivots() == negative);
}

TEST_CASE("Several threads factorise and solve to the same bits as one") {
    const auto lower = lattice(110, 3, 0.5);
    WorkTeam team(GENERATE(2u, 5u));
    SupernodalLdlt one(lower, 3), several(lower, 3, &team);
    REQUIRE(one.factorise(lower, never) == LdltOutcome::done);
    REQUIRE(several.factorise(lower, never) == LdltOutcome::done);
    CHECK(several.negativePivots() == one.negativePivots());
    const Vectors right = fixedRandomBlock(lower.rows(), GENERATE(4, 8), 5);
    Vectors x = right, y = right;
    one.solve(x);
    several.solve(y);
    CHECK(x == y);
    const Eigen::SparseMatrix<double> full = lower.selfadjointView<Eigen::Lower>();
    CHECK((full * x - right).norm() < 1e-8 * right.norm());
}

TEST_CASE("A factorisation on several threads can be stopped and repeated") {
    const auto lower = lattice(110, 3, 0.5);
    WorkTeam team(2);
    SupernodalLdlt factor(lower, 3, &team);
    int count = 0;
    CHECK(factor.factorise(lower, [&] { return ++count == 3; }) == LdltOutcome::stopped);
    CHECK(factor.factorise(lower, never) == LdltOutcome::done);
}
