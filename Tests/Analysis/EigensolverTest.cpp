#include "Analysis/Eigensolver.h"

#include "Analysis/QuadraticTetrahedra.h"
#include "Analysis/SpringMassModel.h"
#include "Analysis/TetMesh.h"
#include "Analysis/TwoLayerShell.h"
#include "Geometry/ParametricMesh.h"
#include "TestMaterials.h"

#include <Eigen/Eigenvalues>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

/// A line of masses with equal springs, one degree of freedom each: λ_j = 4 k/m sin²(π j/2n).
VibrationModel freeChain(int masses, double stiffness, double mass) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < masses; ++i) {
        entries.emplace_back(i, i, stiffness * (i == 0 || i == masses - 1 ? 1 : 2));
        if (i > 0)
            entries.emplace_back(i, i - 1, -stiffness);
    }
    VibrationModel model{.stiffness = Eigen::SparseMatrix<double>(masses, masses),
                         .mass = diagonalMass(Eigen::VectorXd::Constant(masses, mass))};
    model.stiffness.setFromTriplets(entries.begin(), entries.end());
    return model;
}

double hertz(double lambda) {
    return std::sqrt(lambda) / (2 * std::numbers::pi);
}

void checkInvariants(const VibrationModel& model, const Modes& modes) {
    const auto& g = modes.shapes;
    const Eigen::MatrixXd momentum = model.mass.selfadjointView<Eigen::Lower>() * g;
    const Eigen::MatrixXd mass = g.transpose() * momentum;
    CHECK((mass - Eigen::MatrixXd::Identity(g.cols(), g.cols())).cwiseAbs().maxCoeff() < 1e-8);
    const Eigen::MatrixXd image = model.stiffness.selfadjointView<Eigen::Lower>() * g;
    const Eigen::MatrixXd stiffness = g.transpose() * image;
    const Eigen::MatrixXd lambda = modes.eigenvalues.asDiagonal();
    // Compare each element with the geometric mean of its row's and column's eigenvalues.
    const Eigen::VectorXd scale = modes.eigenvalues.cwiseSqrt().cwiseInverse();
    CHECK((scale.asDiagonal() * (stiffness - lambda) * scale.asDiagonal()).cwiseAbs().maxCoeff() <
          1e-8);
    // Residuals: the vectors must be eigenvectors, not only diagonalise within their span.
    const Eigen::MatrixXd residual = model.mass.diagonal().cwiseSqrt().cwiseInverse().asDiagonal() *
                                     (image - momentum * modes.eigenvalues.asDiagonal());
    for (Eigen::Index i = 0; i < g.cols(); ++i)
        REQUIRE(residual.col(i).norm() < 1e-5 * modes.eigenvalues(i));
}

} // namespace

TEST_CASE("A chain of masses has its closed-form frequencies, small (dense) or large (sparse)") {
    const int n = GENERATE(50, 3000);
    const double k = 1e9, m = 1;
    const double highest = hertz(4 * k / m * std::pow(std::sin(0.1), 2));
    const auto modes =
        solveModes(freeChain(n, k, m), {.lowestHz = 1e-3 * highest, .highestHz = highest});
    REQUIRE(modes);
    CHECK(modes->zeroModes == 1);
    int expected = 0;
    for (int j = 1; j < n; ++j) {
        const double lambda = 4 * k / m * std::pow(std::sin(std::numbers::pi * j / (2.0 * n)), 2);
        if (hertz(lambda) < 1e-3 * highest || hertz(lambda) > highest)
            continue;
        REQUIRE(expected < modes->eigenvalues.size());
        REQUIRE(std::abs(modes->eigenvalues(expected) / lambda - 1) < 1e-8);
        ++expected;
    }
    CHECK(modes->eigenvalues.size() == expected);
}

TEST_CASE("Mass and stiffness are diagonal in the modes within 1e-8 for every model") {
    const auto material = referenceWood();
    const auto sheet = twoLayerShell(sheetMesh(0.4, 0.05, 600), material, 0.02);
    const auto sphere =
        springMassModel(icosphereMesh(0.1, 3), material, 0.005, SpringStiffness::vanGelder);
    const auto box = springMassModel(boxMesh({0.4, 0.05, 0.02}, {20, 4, 2}), material, 0.005,
                                     SpringStiffness::literal);
    for (const auto* model : {&sheet, &sphere, &box}) {
        const auto modes = solveModes(*model, {.lowestHz = 20, .highestHz = 22000});
        REQUIRE(modes);
        REQUIRE(modes->eigenvalues.size() > 20);
        checkInvariants(*model, *modes);
    }
}

TEST_CASE("A sliced spectrum has every mode once and matches the dense solution") {
    // 1926 degrees of freedom, some 700 modes in the band: several slices, many degenerate modes.
    const auto model =
        springMassModel(icosphereMesh(0.1, 3), referenceWood(), 0.005, SpringStiffness::vanGelder);
    const Eigen::VectorXd scale = model.mass.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd full = Eigen::MatrixXd(model.stiffness).selfadjointView<Eigen::Lower>();
    const Eigen::VectorXd dense =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
            scale.asDiagonal() * full * scale.asDiagonal(), Eigen::EigenvaluesOnly)
            .eigenvalues();
    const double highest = hertz(std::sqrt(dense(700) * dense(701)));
    const auto modes = solveModes(model, {.lowestHz = 20, .highestHz = highest});
    REQUIRE(modes);
    REQUIRE(modes->eigenvalues.size() == 701 - 6);
    for (Eigen::Index i = 0; i < modes->eigenvalues.size(); ++i)
        REQUIRE(std::abs(modes->eigenvalues(i) / dense(i + 6) - 1) < 1e-7);
    checkInvariants(model, *modes);
}

TEST_CASE("Hundreds of zero modes are separated without losing other modes") {
    const auto model = springMassModel(boxMesh({0.4, 0.05, 0.02}, {40, 6, 3}), referenceWood(),
                                       0.005, SpringStiffness::literal);
    const auto modes = solveModes(model, {.lowestHz = 20, .highestHz = 8000});
    REQUIRE(modes);
    CHECK(modes->zeroModes == 572);
    CHECK(modes->zeroModes + modes->belowBand + modes->eigenvalues.size() ==
          *countModesBelow(model, 8000));
    checkInvariants(model, *modes);
}

TEST_CASE("Modes between zero and the band are counted but not returned") {
    const auto model = twoLayerShell(sheetMesh(0.4, 0.05, 300), referenceWood(), 0.02);
    const auto all = solveModes(model, {.lowestHz = 20, .highestHz = 5000});
    const auto some = solveModes(model, {.lowestHz = 1000, .highestHz = 5000});
    REQUIRE(all);
    REQUIRE(some);
    CHECK(some->zeroModes == 6);
    CHECK(some->belowBand == all->eigenvalues.size() - some->eigenvalues.size());
    CHECK(some->belowBand > 0);
}

TEST_CASE("More modes than the limit give an error with the number") {
    const auto model = twoLayerShell(sheetMesh(0.4, 0.05, 300), referenceWood(), 0.02);
    const auto modes = solveModes(model, {.lowestHz = 20, .highestHz = 20000, .maximumModes = 10});
    REQUIRE_FALSE(modes);
    CHECK_THAT(modes.error().message, Catch::Matchers::ContainsSubstring("limit of 10"));
}

TEST_CASE("A solve stops at the next step after cancellation, and progress never falls") {
    const auto model = twoLayerShell(sheetMesh(1, 1, 1500), referenceWood(), 0.01);
    for (const double cancelAt : {0.0, 0.01, 0.3, 0.6}) {
        CAPTURE(cancelAt);
        std::atomic<bool> cancelled = false;
        double last = 0;
        int reportsAfter = 0;
        bool fell = false;
        const WorkControl control{.progress =
                                      [&](double fraction, std::string_view) {
                                          fell = fell || fraction < last || fraction > 1;
                                          last = fraction;
                                          reportsAfter += cancelled ? 1 : 0;
                                          cancelled = cancelled || fraction >= cancelAt;
                                      },
                                  .cancelled = &cancelled};
        const auto modes = solveModes(model, {.lowestHz = 20, .highestHz = 15000}, control);
        REQUIRE_FALSE(modes);
        CHECK(modes.error().message == cancelledMessage);
        CHECK(last >= cancelAt);
        CHECK(reportsAfter == 0);
        CHECK_FALSE(fell);
    }
}

TEST_CASE("Modes have the same bits on one thread and on several", "[.weekly]") {
    const auto mesh =
        tetrahedralise(boxMesh({0.2, 0.16, 0.12}, {12, 10, 8}), {.targetEdgeMetres = 0.017});
    REQUIRE(mesh);
    const auto model = quadraticTetrahedra(*mesh, elasticLaw(referenceWood()), 1000);
    REQUIRE(model.stiffness.rows() > 18000); // enough for parts on several threads
    const auto one = solveModes(model, {.lowestHz = 20, .highestHz = 16000, .threads = 1});
    REQUIRE(one);
    CHECK(one->eigenvalues.size() > 10);
    for (const unsigned threads : {2U, 3U}) {
        const auto several =
            solveModes(model, {.lowestHz = 20, .highestHz = 16000, .threads = threads});
        REQUIRE(several);
        CHECK(several->eigenvalues == one->eigenvalues);
        CHECK(several->shapes == one->shapes);
    }
}
