#include "Analysis/BlockLanczos.h"

#include "Analysis/TwoLayerShell.h"
#include "Geometry/ParametricMesh.h"
#include "TestMaterials.h"

#include <Eigen/Eigenvalues>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <stdexcept>

using namespace idiophone;
using namespace idiophone::test;
using Eigen::Index;
using Eigen::MatrixXd;

namespace {

struct DenseModes {
    Eigen::VectorXd values;
    Vectors vectors;
};

DenseModes denseModes(const VibrationModel& model) {
    const MatrixXd stiffness = MatrixXd(model.stiffness).selfadjointView<Eigen::Lower>();
    const MatrixXd mass = MatrixXd(model.mass).selfadjointView<Eigen::Lower>();
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(stiffness, mass);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

/// A diagonal model in which every eigenvalue occurs `copies` times.
VibrationModel copiedModel(int different, int copies) {
    VibrationModel model;
    Eigen::VectorXd values(different * copies);
    for (Index i = 0; i < values.size(); ++i)
        values(i) = 1e6 * (1 + static_cast<double>(i % different));
    model.stiffness = diagonalMass(values);
    model.mass = diagonalMass(Eigen::VectorXd::Ones(values.size()));
    return model;
}

} // namespace

TEST_CASE("The modes nearest to a shift match the dense solution and are M-orthonormal") {
    const auto model = twoLayerShell(sheetMesh(0.4, 0.3, 100), referenceWood(), 0.008);
    const auto dense = denseModes(model);
    const WorkControl control;
    ShiftedFactor factor(model, control);
    const MassSpace space(model.mass);
    const Index first = GENERATE(6, 40), wanted = 30;
    const double low = (dense.values(first - 1) + dense.values(first)) / 2;
    const double high = (dense.values(first + wanted - 1) + dense.values(first + wanted)) / 2;
    REQUIRE(factor.factorise(first == 6 ? low : (low + high) / 2));
    int steps = 0;
    const auto found = nearestModes(
        factor, space, Vectors(space.rows(), 0),
        {.low = low, .high = high, .wanted = wanted, .seed = 1, .step = [&] { ++steps; }});
    REQUIRE(found.values.size() == wanted);
    CHECK(steps > 5);
    for (Index i = 0; i < wanted; ++i)
        CHECK(std::abs(found.values(i) / dense.values(first + i) - 1) < 1e-9);
    const Vectors products = innerProducts(found.vectors, space.times(found.vectors));
    CHECK((products - Vectors::Identity(wanted, wanted)).cwiseAbs().maxCoeff() < 1e-8);
}

TEST_CASE("Known modes are not found again") {
    const auto model = twoLayerShell(sheetMesh(0.4, 0.3, 100), referenceWood(), 0.008);
    const auto dense = denseModes(model);
    const WorkControl control;
    ShiftedFactor factor(model, control);
    const MassSpace space(model.mass);
    const double low = -1e4, high = (dense.values(25) + dense.values(26)) / 2;
    REQUIRE(factor.factorise(low));
    const Vectors before = dense.vectors.leftCols(16);
    const auto found = nearestModes(factor, space, before,
                                    {.low = low, .high = high, .wanted = 10, .step = [] {}});
    REQUIRE(found.values.size() == 10);
    for (Index i = 0; i < 10; ++i)
        CHECK(std::abs(found.values(i) / dense.values(16 + i) - 1) < 1e-9);
    const Vectors products = innerProducts(before, space.times(found.vectors));
    CHECK(products.cwiseAbs().maxCoeff() < 1e-8);
}

TEST_CASE(
    "Multiple eigenvalues beyond the block size are found by repeated calls, without extra ones") {
    const auto model = copiedModel(40, 15);
    const WorkControl control;
    ShiftedFactor factor(model, control);
    const MassSpace space(model.mass);
    REQUIRE(factor.factorise(0.5e6));
    Vectors all(space.rows(), 0);
    for (unsigned pass = 0; all.cols() < 30; ++pass) {
        REQUIRE(pass < 10);
        const auto fresh = nearestModes(
            factor, space, all,
            {.low = 0.5e6, .high = 2.5e6, .wanted = 30 - all.cols(), .seed = pass, .step = [] {}});
        for (const double value : fresh.values)
            CHECK((std::abs(value / 1e6 - 1) < 1e-9 || std::abs(value / 2e6 - 1) < 1e-9));
        const Index had = all.cols();
        all.conservativeResize(Eigen::NoChange, had + fresh.values.size());
        all.rightCols(fresh.values.size()) = fresh.vectors;
    }
    CHECK(all.cols() == 30);
    CHECK(nearestModes(factor, space, all,
                       {.low = 0.5e6, .high = 2.5e6, .wanted = 1, .seed = 99, .step = [] {}})
              .values.size() == 0);
}

TEST_CASE("Exceptions from the step function propagate") {
    const auto model = twoLayerShell(sheetMesh(0.4, 0.3, 100), referenceWood(), 0.008);
    const WorkControl control;
    ShiftedFactor factor(model, control);
    REQUIRE(factor.factorise(-1e4));
    const auto stop = [] { throw std::runtime_error("stop"); };
    CHECK_THROWS_AS(nearestModes(factor, MassSpace(model.mass), Vectors(model.mass.rows(), 0),
                                 {.low = -1e4, .high = 1e9, .wanted = 10, .step = stop}),
                    std::runtime_error);
}
