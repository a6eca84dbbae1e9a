#include "Analysis/MassSpace.h"

#include "Analysis/BlockLanczos.h"
#include "Analysis/DenseKernels.h"
#include "Analysis/KrylovBasis.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <limits>

using namespace idiophone;
using Eigen::Index;
using Eigen::MatrixXd;

namespace {

/// A diagonally dominant, tridiagonal mass matrix.
Eigen::SparseMatrix<double> chainMass(Index n) {
    Eigen::SparseMatrix<double> lower(n, n);
    for (Index i = 0; i < n; ++i) {
        lower.insert(i, i) = 2 + 0.3 * static_cast<double>(i % 5);
        if (i + 1 < n)
            lower.insert(i + 1, i) = 0.5;
    }
    return lower;
}

} // namespace

TEST_CASE("The kernel for this processor multiplies like Eigen for all sizes") {
    for (const Index rows : {1, 3, 4, 9, 18})
        for (const Index columns : {1, 3, 4, 5, 8, 13, 29})
            for (const Index inner : {0, 1, 7, 33}) {
                CAPTURE(rows, columns, inner);
                const Vectors a = fixedRandomBlock(rows, inner + 2, 1);
                const Vectors b = fixedRandomBlock(inner, columns + 3, 2);
                const Vectors before = fixedRandomBlock(rows, columns + 1, 3);
                const Vectors transposed = a.transpose();
                for (const bool isTransposed : {false, true}) {
                    Vectors c = before;
                    const Index width = transposed.cols();
                    addProduct({rows, columns, inner, -2,
                                isTransposed ? transposed.data() : a.data(),
                                isTransposed ? 1 : a.cols(), isTransposed ? width : 1, b.data(),
                                b.cols(), c.data(), c.cols()});
                    Vectors expected = before;
                    expected.leftCols(columns) -=
                        2 * MatrixXd(a.leftCols(inner)) * MatrixXd(b.leftCols(columns));
                    REQUIRE((c - expected).cwiseAbs().maxCoeff() < 1e-14);
                }
            }
}

TEST_CASE("A symmetric matrix given by its lower triangle multiplies like the full one") {
    const auto lower = chainMass(100);
    const Vectors x = fixedRandomBlock(100, GENERATE(1, 4, 6, 8, 11), 1);
    const MatrixXd whole = MatrixXd(lower).selfadjointView<Eigen::Lower>();
    CHECK((symmetricTimes(lower, x) - whole * x).cwiseAbs().maxCoeff() < 1e-14);
}

TEST_CASE("Orthonormal columns times their triangle give the vectors back, even if these are "
          "near-parallel") {
    const auto mass = chainMass(300);
    const MassSpace space(mass);
    Vectors block = fixedRandomBlock(300, 8, 4);
    block.col(5) = 1e3 * block.col(2) + GENERATE(1.0, 1e-3) * block.col(5);
    const Vectors before = block;
    Vectors image;
    const MatrixXd back = space.orthonormalise(block, image);
    REQUIRE(back.cols() == 8);
    CHECK((block * back - before).norm() < 1e-12 * before.norm());
    CHECK((MatrixXd(block.transpose() * image) - MatrixXd::Identity(8, 8)).norm() < 1e-13);
    CHECK((image - space.times(block)).norm() < 1e-13 * image.norm());
    CHECK(back.isUpperTriangular());
}

TEST_CASE("Dependent, zero and infinite columns have no orthonormal basis") {
    const auto mass = chainMass(50);
    Vectors block = fixedRandomBlock(50, 4, 4), image;
    const std::vector<Eigen::VectorXd> columns = {
        block.col(0), Eigen::VectorXd::Zero(50),
        Eigen::VectorXd::Constant(50, std::numeric_limits<double>::infinity())};
    for (const auto& column : columns) {
        block.col(3) = column;
        Vectors own = block;
        CHECK(MassSpace(mass).orthonormalise(own, image).size() == 0);
    }
}

TEST_CASE("Projection removes the basis from vectors, in one block or several") {
    const auto mass = chainMass(300);
    const MassSpace space(mass);
    Vectors basis = fixedRandomBlock(300, 12, 4), image;
    REQUIRE(space.orthonormalise(basis, image).size() > 0);
    Vectors block = fixedRandomBlock(300, 5, 6), same = block;
    space.projectOut(basis, block);
    CHECK(MatrixXd(basis.transpose() * space.times(block)).cwiseAbs().maxCoeff() < 1e-14);

    KrylovBasis blocks;
    blocks.append(basis.leftCols(4));
    blocks.append(basis.rightCols(8));
    CHECK(blocks.size() == 12);
    blocks.projectOut(space.times(same), same);
    CHECK((same - block).cwiseAbs().maxCoeff() < 1e-14);
    const Vectors coefficients = fixedRandomBlock(12, 7, 8);
    CHECK((blocks.combinations(coefficients) - basis * coefficients).cwiseAbs().maxCoeff() < 1e-14);
}
