#include "Analysis/ElasticLaw.h"

#include "TestMaterials.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinRel;

TEST_CASE("The isotropic law is Lame's law") {
    const double y = 20e9, nu = 0.3;
    const double lambda = y * nu / ((1 + nu) * (1 - 2 * nu)), mu = y / (2 * (1 + nu));
    Matrix6d lame = Matrix6d::Zero();
    lame.topLeftCorner<3, 3>().setConstant(lambda);
    lame.diagonal() << lambda + 2 * mu, lambda + 2 * mu, lambda + 2 * mu, mu, mu, mu;
    CHECK((elasticLaw(referenceWood(nu)).stiffnessPa - lame).norm() < 1e-12 * lame.norm());
}

TEST_CASE("An isotropic law is the same along any grain") {
    const auto elasticity = isotropicElasticity(20e9, 0.3);
    const auto straight = elasticLaw(elasticity);
    const auto turned =
        elasticLaw(elasticity, {.grain = {1, 2, 3}, .radial = Eigen::Vector3d(-1, 1, 0.5)});
    CHECK((straight.stiffnessPa - turned.stiffnessPa).norm() < 1e-12 * straight.stiffnessPa.norm());
}

TEST_CASE("A wood's law returns its constants along its axes") {
    const auto law = elasticLaw(
        roundWood, {.grain = Eigen::Vector3d::UnitY(), .radial = Eigen::Vector3d::UnitX()});
    const Matrix6d s = law.stiffnessPa.inverse();
    CHECK_THAT(1 / s(1, 1), WithinRel(16e9, 1e-12)); // L along y
    CHECK_THAT(1 / s(0, 0), WithinRel(2e9, 1e-12));  // R along x
    CHECK_THAT(1 / s(2, 2), WithinRel(1e9, 1e-12));  // T along z
    CHECK_THAT(1 / s(5, 5), WithinRel(1.2e9, 1e-12));
    CHECK_THAT(1 / s(4, 4), WithinRel(0.3e9, 1e-12));
    CHECK_THAT(1 / s(3, 3), WithinRel(0.9e9, 1e-12));
    CHECK_THAT(-s(0, 1) / s(1, 1), WithinRel(0.3, 1e-12));
    CHECK_THAT(-s(2, 0) / s(0, 0), WithinRel(0.5, 1e-12));
    CHECK_THAT(-s(2, 1) / s(1, 1), WithinRel(0.4, 1e-12));
}

TEST_CASE("Young's modulus at an angle to the grain follows the compliance transformation") {
    const double angle = 0.5, c = std::cos(angle), s = std::sin(angle);
    const auto law = elasticLaw(
        roundWood, {.grain = Eigen::Vector3d(c, s, 0), .radial = Eigen::Vector3d(-s, c, 0)});
    // Jones, Mechanics of Composite Materials, eq. 2.97: off-axis modulus of a lamina.
    const double inverse =
        std::pow(c, 4) / 16e9 + (1 / 1.2e9 - 2 * 0.3 / 16e9) * c * c * s * s + std::pow(s, 4) / 2e9;
    CHECK_THAT(law.stiffnessPa.inverse()(0, 0), WithinRel(inverse, 1e-12));
}

TEST_CASE("The radial direction is made perpendicular to the grain") {
    const auto exact = elasticLaw(roundWood, {.grain = {2, 0, 0}});
    const auto leaning =
        elasticLaw(roundWood, {.grain = {1, 0, 0}, .radial = Eigen::Vector3d(5, 0, 3)});
    CHECK((exact.stiffnessPa - leaning.stiffnessPa).norm() < 1e-12 * exact.stiffnessPa.norm());
}

TEST_CASE("The slowest wave of an isotropic body is its shear wave") {
    const auto material = referenceWood(0.3);
    const auto law = elasticLaw(material);
    CHECK_THAT(slowestShearSpeedMetresPerSecond(law, 1000),
               WithinRel(std::sqrt(20e9 / 2.6 / 1000), 1e-9));
    CHECK_THAT(minimumYoungsModulusPa(law), WithinRel(20e9, 1e-9));
}

TEST_CASE(
    "Wood's slowest wave is at most rolling shear, and its minimum modulus is across the grain") {
    const auto law = elasticLaw(roundWood);
    const double rolling = std::sqrt(0.3e9 / 700);
    CHECK(slowestShearSpeedMetresPerSecond(law, 700) <= rolling * 1.02);
    CHECK(slowestShearSpeedMetresPerSecond(law, 700) > 0.7 * rolling);
    CHECK(minimumYoungsModulusPa(law) < 1e9 * 1.02);
}
