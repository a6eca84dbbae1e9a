#include "Analysis/BoundaryElements.h"

#include "Analysis/Air.h"
#include "Analysis/ClosedSurface.h"
#include "Geometry/ParametricMesh.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

using namespace idiophone;
using Catch::Matchers::WithinAbs;

namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;
constexpr double impedance = airDensityKgPerM3 * speedOfSoundMetresPerSecond;
const Complex j(0, 1);

/// Returns the identity alone, whatever the mesh.
SurfaceSymmetry noSymmetry(const Mesh& mesh) {
    std::vector<int> faces(static_cast<std::size_t>(mesh.faceCount()));
    std::iota(faces.begin(), faces.end(), 0);
    return {.images = {faces}, .characters = Eigen::MatrixXcd::Ones(1, 1)};
}

double decibels(Complex actual, Complex expected) {
    return 20 * std::log10(std::abs(actual / expected));
}

/// A unit sphere from an octahedron with edges divided by n. It has all three mirror symmetries.
Mesh octasphere(int n) {
    std::map<std::array<int, 3>, int> numbers;
    std::vector<Eigen::RowVector3i> faces;
    for (const int x : {1, -1})
        for (const int y : {1, -1})
            for (const int z : {1, -1}) {
                const auto vertex = [&](int a, int b) {
                    const std::array<int, 3> place{x * a, y * b, z * (n - a - b)};
                    return numbers.try_emplace(place, static_cast<int>(numbers.size()))
                        .first->second;
                };
                const auto add = [&](int a, int b, int c) {
                    faces.emplace_back(a, x * y * z > 0 ? b : c, x * y * z > 0 ? c : b);
                };
                for (int a = 0; a < n; ++a)
                    for (int b = 0; a + b < n; ++b) {
                        add(vertex(a, b), vertex(a + 1, b), vertex(a, b + 1));
                        if (a + b + 1 < n)
                            add(vertex(a + 1, b), vertex(a + 1, b + 1), vertex(a, b + 1));
                    }
            }
    Mesh mesh{Eigen::MatrixXd(static_cast<Eigen::Index>(numbers.size()), 3),
              Eigen::MatrixXi(static_cast<Eigen::Index>(faces.size()), 3)};
    for (const auto& [place, number] : numbers)
        mesh.vertices.row(number) = Eigen::RowVector3d(place[0], place[1], place[2]).normalized();
    for (std::size_t face = 0; face < faces.size(); ++face)
        mesh.faces.row(static_cast<Eigen::Index>(face)) = faces[face];
    return mesh;
}

/// Returns the [F×3] unit normals.
Eigen::MatrixXd faceNormals(const Mesh& mesh) {
    Eigen::MatrixXd normals(mesh.faceCount(), 3);
    const auto panels = boundaryPanels(mesh);
    for (Eigen::Index face = 0; face < normals.rows(); ++face)
        normals.row(face) = panels[static_cast<std::size_t>(face)].normal.transpose();
    return normals;
}

/// [D×M]
Eigen::MatrixXcd weights(const BoundaryElements& elements,
                         double waveNumber,
                         const Eigen::MatrixXd& directions,
                         const Eigen::MatrixXd& velocities) {
    const auto pressures = elements.surfacePressures(waveNumber, velocities);
    REQUIRE(pressures);
    return elements.farField(waveNumber, directions, Eigen::Vector3d::Zero(), velocities,
                             *pressures);
}

/// Returns the weight on an axis of a surface that moves along it as a rigid body.
Complex translationWeight(const ClosedSurface& surface, double waveNumber, int axis) {
    const BoundaryElements elements(surface.mesh, surfaceSymmetry(surface.mesh));
    const Eigen::RowVector3d direction = Eigen::RowVector3d::Unit(axis);
    return weights(elements, waveNumber, direction, faceNormals(surface.mesh).col(axis))(0, 0);
}

/// Returns ∏ (2i + 1), i ≤ n, times j_n(x)/x^n, which is 1 at x = 0. Uses the series for small x
/// and upward recursion where that is stable.
double scaledBessel(int n, double x) {
    if (x < n + 3.0) {
        double term = 1, sum = 1;
        for (int i = 1; i < 60; ++i) {
            term *= -x * x / (2.0 * i * (2.0 * (n + i) + 1));
            sum += term;
        }
        return sum;
    }
    double last = std::sin(x) / x, value = (last - std::cos(x)) / x, scale = 3 / x;
    for (int order = 1; order < n; ++order) {
        const double next = (2 * order + 1) / x * value - last;
        last = value;
        value = next;
        scale *= (2 * order + 3) / x;
    }
    return value * scale;
}

/// Returns the weight of a free disc without thickness, of radius 1, that moves along its axis at 1
/// m/s, at an angle to the axis. The pressure on its face is a sum of (1 − r²)^{m+1/2} with Hankel
/// transforms j_{m+1}(κ)/κ^{m+1}. The condition on ∂p/∂z on the disc is met in the mean over each
/// term (Galerkin).
Complex freeDisc(double k, double angle) {
    constexpr int terms = 7;
    constexpr double last = 600, step = 0.02;
    Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Zero(terms, terms);
    const auto addPoint = [&](double kappa, Complex weight) {
        Eigen::VectorXd values(terms);
        for (int m = 0; m < terms; ++m)
            values(m) = scaledBessel(m + 1, kappa);
        matrix += weight * (values * values.transpose());
    };
    // ∫ Φ Φ γ κ dκ, γ² = κ² − k² = ± s².
    for (double s = step / 2; s < last; s += step)
        addPoint(std::hypot(k, s), step * s * s);
    const double fine = k / 400;
    for (double s = fine / 2; s < k; s += fine)
        addPoint(std::sqrt(k * k - s * s), j * fine * s * s);
    const Eigen::VectorXcd source = j * impedance * k * Eigen::VectorXcd::Ones(terms);
    const Eigen::VectorXcd shares = matrix.lu().solve(source);
    Complex transform = 0;
    for (int m = 0; m < terms; ++m)
        transform += shares(m) * scaledBessel(m + 1, k * std::sin(angle));
    return j * k * std::cos(angle) * transform;
}

/// A reference bar: a box whose cross-sections move up and down like the middle of its top.
struct BoxBar {
    Eigen::Vector3d sizeMetres;
    double halfStep, archStep; ///< spacing of the points of `upward`, up to the arch's edge
    double frequencyHz;
    std::array<double, 9> upward; ///< 1/√kg, from the middle to the end
    bool isOdd = false;
    double expectedWeight; ///< at 25° from the axis, across the bar
};

} // namespace

TEST_CASE("Pulsating and oscillating spheres are within 0.5 dB from ka 0.05 to 20") {
    const Mesh sphere = octasphere(16);
    const BoundaryElements elements(sphere, surfaceSymmetry(sphere));
    CHECK(elements.symmetryOrder() == 8);
    Eigen::MatrixXd velocities(sphere.faceCount(), 2);
    velocities << Eigen::VectorXd::Ones(sphere.faceCount()), faceNormals(sphere).col(2);
    Eigen::MatrixXd directions(2, 3);
    directions << 0, 0, 1, 0.48, 0.64, 0.6;
    // π, 4.4934 and 2π are resonances of the interior: zeros of j_0 and j_1.
    for (const double ka : {0.05, 0.3, 1.0, pi, 4.4934, 2 * pi, 10.0, 20.0}) {
        const auto actual = weights(elements, ka, directions, velocities);
        const Complex pulsating = impedance * j * ka / (1.0 + j * ka) * std::exp(j * ka);
        const Complex oscillating =
            impedance * ka * ka / (ka * ka - 2.0 - 2.0 * j * ka) * std::exp(j * ka);
        INFO("ka " << ka);
        CHECK_THAT(decibels(actual(0, 0), pulsating), WithinAbs(0, 0.5));
        CHECK_THAT(decibels(actual(1, 0), pulsating), WithinAbs(0, 0.5));
        CHECK_THAT(decibels(actual(0, 1), oscillating), WithinAbs(0, 0.5));
        CHECK_THAT(decibels(actual(1, 1), 0.6 * oscillating), WithinAbs(0, 0.5));
    }
}

TEST_CASE("A free disc is within 1 dB of theory, on and off its axis") {
    // Lamb 1932, section 108: an air mass of 8/3 ρ a³ moves with the disc.
    CHECK_THAT(decibels(freeDisc(0.05, 0), 2 / (3 * pi) * impedance * 0.05 * 0.05),
               WithinAbs(0, 0.05));
    const auto disc = closedSurface(discMesh(1, 14), 0.01);
    REQUIRE(disc);
    const BoundaryElements elements(disc->mesh, surfaceSymmetry(disc->mesh));
    CHECK(elements.symmetryOrder() == 12);
    const double angle = pi / 4;
    Eigen::MatrixXd directions(2, 3);
    directions << 0, 0, 1, std::sin(angle), 0, std::cos(angle);
    for (const double ka : {0.1, 1.0, 2.0, 3.5, 5.0}) {
        const auto actual = weights(elements, ka, directions, faceNormals(disc->mesh).col(2));
        INFO("ka " << ka);
        CHECK_THAT(decibels(actual(0, 0), freeDisc(ka, 0)), WithinAbs(0, 1));
        CHECK_THAT(decibels(actual(1, 0), freeDisc(ka, angle)), WithinAbs(0, 1));
    }
}

TEST_CASE("An oscillating cube of 0.1 m radiates 0.73 Pa m at 200 Hz and 14.9 Pa m at 1 kHz") {
    const auto cube =
        closedSurface(boxMesh(Eigen::Vector3d::Constant(0.1), Eigen::Vector3i::Constant(8)), 0);
    REQUIRE(cube);
    const auto weightAt = [&](double frequencyHz) {
        return translationWeight(*cube, 2 * pi * frequencyHz / speedOfSoundMetresPerSecond, 0);
    };
    CHECK_THAT(decibels(weightAt(200), 0.73), WithinAbs(0, 1));
    CHECK_THAT(decibels(weightAt(1000), 14.9), WithinAbs(0, 1));
}

TEST_CASE("Two bars radiate within 1 dB of an independent boundary-element solution") {
    const Eigen::Vector3d xylophone(0.30823, 0.03702, 0.01833), marimba(0.23387, 0.05694, 0.02141);
    const BoxBar bars[] = {
        {xylophone,
         0.0185,
         0.0206,
         523.3,
         {-3.5234, -3.3262, -2.7617, -1.9053, -0.8452, 0.3325, 1.7070, 3.1074, 4.5039},
         false,
         0.81},
        {xylophone,
         0.0185,
         0.0206,
         2994.5,
         {4.3203, 3.3203, 0.9229, -1.5439, -2.9121, -2.7559, -1.1016, 1.4697, 4.1133},
         false,
         8.16},
        {marimba,
         0.01403,
         0.01635,
         261.6,
         {5.7500, 5.4844, 4.7266, 3.5859, 2.2480, 0.8403, -0.5874, -2.2578, -3.9258},
         false,
         1.35},
        {marimba,
         0.01403,
         0.01635,
         2584.3,
         {9.1719, 6.9336, 1.9824, -2.0410, -3.3418, -2.6914, -1.2090, 0.8242, 2.8555},
         false,
         26.8}};
    for (const BoxBar& bar : bars) {
        const auto box = closedSurface(boxMesh(bar.sizeMetres, {48, 8, 4}), 0);
        REQUIRE(box);
        const auto upwardAt = [&](double x) {
            const double edge = 5 * bar.halfStep;
            const double place = std::abs(x) < edge ? std::abs(x) / bar.halfStep
                                                    : 5 + (std::abs(x) - edge) /
                                                              ((bar.sizeMetres.x() / 2 - edge) / 3);
            const auto left = std::min<std::size_t>(7, static_cast<std::size_t>(place));
            return std::lerp(bar.upward[left], bar.upward[left + 1],
                             place - static_cast<double>(left));
        };
        Eigen::MatrixXd shape = Eigen::MatrixXd::Zero(3 * box->mesh.vertexCount(), 1);
        for (Eigen::Index vertex = 0; vertex < box->mesh.vertexCount(); ++vertex)
            shape(3 * vertex + 2) = upwardAt(box->mesh.vertices(vertex, 0));
        const BoundaryElements elements(box->mesh, noSymmetry(box->mesh), 900);
        Eigen::MatrixXd direction(1, 3);
        direction << 0, std::sin(25 * pi / 180), std::cos(25 * pi / 180);
        const auto actual =
            weights(elements, 2 * pi * bar.frequencyHz / speedOfSoundMetresPerSecond, direction,
                    box->normalShapes(shape));
        INFO(bar.frequencyHz << " Hz: " << std::abs(actual(0, 0)));
        CHECK_THAT(decibels(actual(0, 0), bar.expectedWeight), WithinAbs(0, 1));
    }
}

TEST_CASE("A solution with symmetry equals the one without") {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    // These meshes have mirrors, rotations with a mirror across, and mirrors that map faces onto
    // themselves.
    const auto hoop = closedSurface(hoopMesh(0.5, 0.2, 24, 2), 0.02);
    REQUIRE(hoop);
    for (const Mesh& mesh : {octasphere(5), hoop->mesh, icosphereMesh(1, 2)}) {
        const BoundaryElements divided(mesh, surfaceSymmetry(mesh)), whole(mesh, noSymmetry(mesh));
        CHECK(divided.symmetryOrder() > 1);
        const Eigen::MatrixXd velocities =
            Eigen::MatrixXd::NullaryExpr(mesh.faceCount(), 2, [&] { return normal(random); });
        for (const double waveNumber : {0.3, 4.0}) {
            const auto actual = divided.surfacePressures(waveNumber, velocities),
                       expected = whole.surfacePressures(waveNumber, velocities);
            REQUIRE((actual && expected));
            CHECK((*actual - *expected).norm() < 1e-5 * expected->norm());
        }
    }
}

TEST_CASE("The power radiated by the surface equals the power in the far field") {
    // Even steps in both angles, weighted with the area of each band of the sphere.
    constexpr int bands = 60, around = 60;
    Eigen::MatrixXd directions(bands * around, 3);
    Eigen::VectorXd solidAngles(bands * around);
    for (int band = 0; band < bands; ++band)
        for (int k = 0; k < around; ++k) {
            const double polar = pi * (band + 0.5) / bands, angle = 2 * pi * k / around;
            directions.row(band * around + k) << std::sin(polar) * std::cos(angle),
                std::sin(polar) * std::sin(angle), std::cos(polar);
            solidAngles(band * around + k) =
                2 * std::sin(polar) * std::sin(pi / (2 * bands)) * 2 * pi / around;
        }
    const auto sheet = closedSurface(sheetMesh(0.3, 0.2, 900), 0.003);
    REQUIRE(sheet);
    Eigen::MatrixXd shape = Eigen::MatrixXd::Zero(3 * sheet->motion.cols(), 1);
    const Mesh middle = sheetMesh(0.3, 0.2, 900);
    for (Eigen::Index vertex = 0; vertex < middle.vertexCount(); ++vertex)
        shape(3 * vertex + 2) = std::cos(2 * pi * middle.vertices(vertex, 0) / 0.3 + 0.4) *
                                std::cos(pi * middle.vertices(vertex, 1) / 0.2);
    const Eigen::MatrixXd velocities = sheet->normalShapes(shape);
    const BoundaryElements elements(sheet->mesh, surfaceSymmetry(sheet->mesh));
    const Eigen::VectorXd areas = faceAreas(sheet->mesh);
    for (const double frequencyHz : {1500.0, 2500.0, 4000.0}) {
        const double waveNumber = 2 * pi * frequencyHz / speedOfSoundMetresPerSecond;
        const auto pressures = elements.surfacePressures(waveNumber, velocities);
        REQUIRE(pressures);
        const double leaves =
            (pressures->col(0).real().cwiseProduct(velocities.col(0))).dot(areas) / 2;
        const auto heard = elements.farField(waveNumber, directions, Eigen::Vector3d::Zero(),
                                             velocities, *pressures);
        const double arrives = heard.col(0).cwiseAbs2().dot(solidAngles) / (2 * impedance);
        INFO(frequencyHz << " Hz");
        CHECK_THAT(leaves / arrives, WithinAbs(1, 0.05));
    }
}

TEST_CASE("A thin sheet converges as its triangles become smaller than its thickness") {
    std::vector<double> weightsInPaM;
    for (const int vertices : {60, 240, 960}) {
        const auto sheet = closedSurface(sheetMesh(0.06, 0.04, vertices), 0.003);
        REQUIRE(sheet);
        weightsInPaM.push_back(std::abs(translationWeight(*sheet, 10, 2)));
    }
    CHECK_THAT(decibels(weightsInPaM[0], weightsInPaM[2]), WithinAbs(0, 0.6));
    CHECK_THAT(decibels(weightsInPaM[1], weightsInPaM[2]), WithinAbs(0, 0.3));
    CHECK(std::abs(weightsInPaM[1] - weightsInPaM[2]) <
          std::abs(weightsInPaM[0] - weightsInPaM[1]));
}

TEST_CASE("Triangles that share unknowns change the radiated sound by less than 0.5 dB") {
    const Mesh sphere = octasphere(12);
    const BoundaryElements elements(sphere, noSymmetry(sphere), 150);
    CHECK(elements.unknownCount() == 150);
    const Eigen::RowVector3d direction(0, 0, 1);
    for (const double ka : {0.1, 1.0, 3.0}) {
        const Complex expected =
            impedance * ka * ka / (ka * ka - 2.0 - 2.0 * j * ka) * std::exp(j * ka);
        const auto actual = weights(elements, ka, direction, faceNormals(sphere).col(2));
        CHECK_THAT(decibels(actual(0, 0), expected), WithinAbs(0, 0.5));
    }
}
