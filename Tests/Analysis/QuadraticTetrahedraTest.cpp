#include "Analysis/QuadraticTetrahedra.h"

#include "Geometry/ParametricMesh.h"
#include "SolvedBody.h"
#include "TestMaterials.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinRel;

namespace {

TetMesh meshOf(const Mesh& surface, double edge) {
    auto mesh = tetrahedralise(surface, {.targetEdgeMetres = edge});
    REQUIRE(mesh);
    return std::move(*mesh);
}

TetMesh block() {
    return meshOf(boxMesh({0.3, 0.2, 0.1}, {3, 2, 1}), 0.1);
}

Eigen::VectorXd sampled(const TetMesh& mesh, const Field& field) {
    Eigen::VectorXd u(3 * mesh.nodes.rows());
    for (Eigen::Index n = 0; n < mesh.nodes.rows(); ++n)
        u.segment<3>(3 * n) = field(mesh.nodes.row(n).transpose());
    return u;
}

double product(const Eigen::SparseMatrix<double>& lower,
               const Eigen::VectorXd& a,
               const Eigen::VectorXd& b) {
    return a.dot(lower.selfadjointView<Eigen::Lower>() * b);
}

ElementNodes straightElement(const Eigen::Matrix<double, 4, 3>& corners) {
    Eigen::Matrix<int, 1, 4> all(0, 1, 2, 3);
    return nodesOf(withMidEdgeNodes(corners, all, 4), 0);
}

} // namespace

TEST_CASE("A rigid motion of a block of tetrahedra stores no energy") {
    const auto mesh = block();
    const auto model = quadraticTetrahedra(mesh, elasticLaw(referenceWood(0.3)), 1000);
    const double scale = model.stiffness.coeffs().abs().maxCoeff();
    for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
        for (const Field& motion :
             {Field([&](const Eigen::Vector3d&) { return unit; }),
              Field([&](const Eigen::Vector3d& p) { return Eigen::Vector3d(unit.cross(p)); })}) {
            const auto u = sampled(mesh, motion);
            const Eigen::VectorXd force = model.stiffness.selfadjointView<Eigen::Lower>() * u;
            CHECK(force.cwiseAbs().maxCoeff() < 1e-12 * scale);
        }
    }
}

TEST_CASE("Mass, first and second moments of a block are exact") {
    const auto mesh = block();
    const auto model = quadraticTetrahedra(mesh, elasticLaw(referenceWood(0.3)), 1000);
    const double mass = 1000 * 0.3 * 0.2 * 0.1;
    const auto along = sampled(mesh, [](const auto&) { return Eigen::Vector3d(1, 0, 0); });
    const auto stretch = sampled(mesh, [](const auto& p) { return Eigen::Vector3d(p.x(), 0, 0); });
    const auto turn =
        sampled(mesh, [](const auto& p) { return Eigen::Vector3d(-p.y(), p.x(), 0); });
    CHECK_THAT(product(model.mass, along, along), WithinRel(mass, 1e-12));
    CHECK(std::abs(product(model.mass, along, stretch)) < 1e-12 * mass);
    CHECK_THAT(product(model.mass, stretch, stretch), WithinRel(mass * 0.09 / 12, 1e-12));
    CHECK_THAT(product(model.mass, turn, turn), WithinRel(mass * (0.09 + 0.04) / 12, 1e-12));
}

TEST_CASE("Uniform strain stores half of strain times stress, also for wood at an angle") {
    const auto mesh = block();
    const auto law = elasticLaw(roundWood, {.grain = {3, 1, 0.5}});
    const auto model = quadraticTetrahedra(mesh, law, 700);
    Eigen::Matrix3d gradient;
    gradient << 1, 0.3, -0.2, 0.1, -0.5, 0.7, 0.4, 0.2, 0.6;
    const auto u = sampled(mesh, [&](const auto& p) { return Eigen::Vector3d(gradient * p); });
    const Eigen::Matrix3d e = (gradient + gradient.transpose()) / 2;
    Eigen::Matrix<double, 6, 1> strain;
    strain << e(0, 0), e(1, 1), e(2, 2), 2 * e(1, 2), 2 * e(0, 2), 2 * e(0, 1);
    CHECK_THAT(product(model.stiffness, u, u),
               WithinRel(0.006 * strain.dot(law.stiffnessPa * strain), 1e-11));
}

TEST_CASE(
    "Pure bending, a quadratic displacement, stores exactly E k^2/2 times the second moment") {
    const auto mesh = block();
    const double nu = 0.3, curvature = 0.8;
    const auto model = quadraticTetrahedra(mesh, elasticLaw(referenceWood(nu)), 1000);
    const auto u = sampled(mesh, [&](const auto& p) {
        return Eigen::Vector3d(
            curvature *
            Eigen::Vector3d(-p.x() * p.z(), nu * p.y() * p.z(),
                            (p.x() * p.x() + nu * (p.z() * p.z() - p.y() * p.y())) / 2));
    });
    CHECK_THAT(product(model.stiffness, u, u),
               WithinRel(20e9 * curvature * curvature * 0.3 * 0.2 * std::pow(0.1, 3) / 12, 1e-11));
}

TEST_CASE("The element's mass shares are exact integrals of products of its shape functions") {
    // Integration points in a tetrahedron: Stroud's conical product of Gauss's rule.
    constexpr std::array gauss{0.0694318442029737, 0.3300094782075719, 0.6699905217924281,
                               0.9305681557970263};
    constexpr std::array weight{0.1739274225687269, 0.3260725774312731, 0.3260725774312731,
                                0.1739274225687269};
    Eigen::Matrix<double, 10, 10> integral = Eigen::Matrix<double, 10, 10>::Zero();
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            for (int k = 0; k < 4; ++k) {
                const double a = gauss[i], b = gauss[j] * (1 - a), c = gauss[k] * (1 - a - b);
                const Eigen::Vector4d l(1 - a - b - c, a, b, c);
                Eigen::Matrix<double, 10, 1> shape;
                for (int n = 0; n < 4; ++n)
                    shape(n) = l(n) * (2 * l(n) - 1);
                for (int e = 0; e < 6; ++e)
                    shape(4 + e) = 4 * l(tetrahedronEdges[e].first) * l(tetrahedronEdges[e].second);
                integral += 6 * weight[i] * weight[j] * weight[k] * (1 - a) * (1 - a - b) * shape *
                            shape.transpose();
            }
    // The rule is exact to degree 7 in each factor: 4 from the shapes, 2 from the cone.
    CHECK((integral - elementMassShares()).cwiseAbs().maxCoeff() < 1e-14);
}

TEST_CASE("An element's stiffness does not depend on the order of its corners") {
    Eigen::Matrix<double, 4, 3> corners;
    corners << 0, 0, 0, 1, 0.1, 0, 0.2, 0.9, 0.1, 0.3, 0.2, 1.1;
    const auto law = elasticLaw(referenceWood(0.3));
    Eigen::Matrix<double, 4, 3> turned;
    turned << corners.row(1), corners.row(2), corners.row(0), corners.row(3);
    const auto first = elementIntegrals(straightElement(corners), law).stiffness,
               second = elementIntegrals(straightElement(turned), law).stiffness;
    const Eigen::VectorXd a = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(first).eigenvalues(),
                          b = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(second).eigenvalues();
    CHECK((a - b).cwiseAbs().maxCoeff() < 1e-12 * a.maxCoeff());
    CHECK(a.head<6>().cwiseAbs().maxCoeff() < 1e-12 * a.maxCoeff());
    CHECK(a(6) > 1e-6 * a.maxCoeff());
}

TEST_CASE("A wooden bar rotated with its grain keeps its frequencies within 1e-8") {
    const OrthotropicElasticity& wood = roundWood;
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
    auto mesh = meshOf(boxMesh({0.3, 0.04, 0.02}, {10, 2, 1}), 0.03);
    const auto straight = elasticLaw(wood),
               turned =
                   elasticLaw(wood, {.grain = turn.col(0), .radial = Eigen::Vector3d(turn.col(2))});
    const FrequencyBand band{.lowestHz = 20, .highestHz = 5000};
    const auto before = solveModes(quadraticTetrahedra(mesh, straight, 700), band);
    mesh.nodes = (mesh.nodes * turn.transpose()).eval();
    const auto after = solveModes(quadraticTetrahedra(mesh, turned, 700), band);
    REQUIRE(before);
    REQUIRE(after);
    REQUIRE(before->eigenvalues.size() == after->eigenvalues.size());
    REQUIRE(before->eigenvalues.size() > 5);
    CHECK((before->eigenvalues.array() / after->eigenvalues.array() - 1).abs().maxCoeff() < 2e-8);
}

TEST_CASE("Frequencies scale with sqrt(E/rho) and inversely with size") {
    const auto at = [](double size, double youngs, double density) {
        auto mesh =
            meshOf(boxMesh(size * Eigen::Vector3d(0.3, 0.05, 0.03), {8, 2, 1}), 0.04 * size);
        auto material = referenceWood(0.3);
        material.youngsModulusPa = youngs;
        const auto modes = solveModes(quadraticTetrahedra(mesh, elasticLaw(material), density),
                                      {.lowestHz = 20, .highestHz = 8000});
        REQUIRE(modes);
        REQUIRE(modes->zeroModes == 6);
        return modes->eigenvalues(0);
    };
    const double reference = at(1, 20e9, 1000);
    CHECK_THAT(at(2, 20e9, 1000), WithinRel(reference / 4, 1e-8));
    CHECK_THAT(at(1, 40e9, 4000), WithinRel(reference / 2, 1e-8));
}

TEST_CASE("A curved element moves rigidly without energy and is exact in uniform strain") {
    Eigen::Matrix<double, 4, 3> corners;
    corners << 0, 0, 0, 1, 0.1, 0, 0.2, 0.9, 0.1, 0.3, 0.2, 1.1;
    ElementNodes nodes = straightElement(corners);
    CHECK_THAT(leastVolumeShare(nodes), WithinRel(1, 1e-12));
    nodes.row(5) += Eigen::RowVector3d(0.05, 0.07, 0.03);
    nodes.row(8) += Eigen::RowVector3d(0.02, -0.04, 0.06);
    const auto law = elasticLaw(referenceWood(0.3));
    const auto [stiffness, volume] = elementIntegrals(nodes, law);
    const auto energy = [&](const Eigen::Matrix3d& gradient) {
        const Eigen::Matrix<double, 3, 10> u = gradient * nodes.transpose();
        return u.reshaped().dot(stiffness * u.reshaped());
    };
    Eigen::Matrix3d turn, shear = Eigen::Matrix3d::Zero();
    turn << 0, -3, 2, 3, 0, -1, -2, 1, 0;
    shear(0, 1) = 1;
    CHECK_THAT(energy(shear), WithinRel(volume * law.stiffnessPa(5, 5), 1e-12));
    CHECK(std::abs(energy(turn)) < 1e-12 * energy(shear));
}

TEST_CASE("The volume share of a tetrahedron that is turned inside out is negative") {
    Eigen::Matrix<double, 4, 3> corners;
    corners << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
    ElementNodes nodes = straightElement(corners);
    nodes.row(4) += Eigen::RowVector3d(0, 0.1, 0.1);
    CHECK(leastVolumeShare(nodes) > 0);
    nodes.row(4) += Eigen::RowVector3d(0, 0.1, 0.1);
    CHECK(leastVolumeShare(nodes) < 0);
}
