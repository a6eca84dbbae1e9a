#include "Analysis/Radiation.h"

#include "Analysis/Eigensolver.h"
#include "Analysis/TwoLayerShell.h"
#include "Geometry/ParametricMesh.h"
#include "TestMaterials.h"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double soundSpeed = 343;

/// A body that owns its data, so that tests can turn and shift it.
struct Body {
    Mesh mesh;
    Eigen::MatrixXd shapes; ///< [3N×M]
    Eigen::VectorXd eigenvalues;
    double thicknessMetres = 0;
    Eigen::Vector3d centreMetres = Eigen::Vector3d::Zero();

    RadiationTable radiation(const RadiationSettings& settings = {}) const {
        auto radiation =
            radiationOf({mesh, shapes, eigenvalues, thicknessMetres, centreMetres}, settings);
        REQUIRE(radiation);
        CHECK(faultOf(radiation->table, static_cast<std::size_t>(eigenvalues.size())).empty());
        return std::move(radiation->table);
    }
};

Body analysed(const Mesh& mesh, double thicknessMetres, double highestHz) {
    const auto modes = solveModes(twoLayerShell(mesh, referenceWood(1.0 / 3), thicknessMetres),
                                  {.highestHz = highestHz});
    REQUIRE(modes);
    return {mesh, midSurfaceShapes(modes->shapes), modes->eigenvalues, thicknessMetres};
}

using Complex = std::complex<double>;

Complex weight(const RadiationTable& table, std::size_t direction, std::size_t ratio, int mode) {
    const auto ratios = table.frequencyRatios.size();
    const auto modes = table.weights.size() / ratios / table.directions.size();
    return Complex(
        table.weights[(direction * ratios + ratio) * modes + static_cast<std::size_t>(mode)]);
}

double decibels(double ratio) {
    return 20 * std::log10(std::abs(ratio));
}

/// A solid sphere with one mode, whose frequency at ratio 1 gives ka = 1. `motion` gives the
/// surface's motion from its normal.
constexpr double radiusMetres = 0.01;

Body sphere(const std::function<Eigen::Vector3d(const Eigen::Vector3d& normal)>& motion) {
    Body body{icosphereMesh(radiusMetres, 3), {}, Eigen::VectorXd(1)};
    body.shapes.resize(3 * body.mesh.vertexCount(), 1);
    for (Eigen::Index v = 0; v < body.mesh.vertexCount(); ++v)
        body.shapes.block<3, 1>(3 * v, 0) =
            motion(body.mesh.vertices.row(v).transpose().normalized());
    body.eigenvalues(0) = std::pow(soundSpeed / radiusMetres, 2);
    return body;
}

/// The ratios reach from below the audible band's lower end at 20 Hz (ka = 0.0037) to near its
/// upper end at 22 kHz (4.03).
const std::vector<double> sphereRatios{0.004, 0.02, 0.1, 0.5, 1, 1.5, 1.9, 2.5, 3.9};
const std::vector<Eigen::Vector3d> alongZ{Eigen::Vector3d::UnitZ()};

/// ρ0 c
constexpr double impedance = 1.204 * soundSpeed;

/// Returns the exact weight on the axis of a sphere with velocity U P_l(cos θ), divided by U; h_l
/// is of the second kind. Morse & Ingard 1968, section 7.1.
Complex exactSphere(int l, double ka) {
    const Complex j(0, 1), wave = std::exp(-j * ka);
    std::array<Complex, 4> h{j * wave / ka, {}, {}, {}}; // h_0 = j e^{−jx}/x
    h[1] = -wave / ka + j * wave / (ka * ka);
    for (std::size_t n = 1; n < 3; ++n)
        h[n + 1] = (2.0 * static_cast<double>(n) + 1) / ka * h[n] - h[n - 1];
    const auto order = static_cast<std::size_t>(l);
    const Complex slope = static_cast<double>(l) / ka * h[order] - h[order + 1];
    // p = A h_l(kr) with A h_l'(ka) = −jρc U, and h_l(kr) goes to j^{l+1} e^{−jkr}/(kr).
    return -j * impedance / slope * std::pow(j, l + 1) * radiusMetres / ka;
}

/// Returns Σ_i w_i φ_i(v) over the modes of one pole: the sound of a strike.
Eigen::MatrixXcd residues(const Body& body, const RadiationTable& table) {
    const auto rows =
        static_cast<Eigen::Index>(table.directions.size() * table.frequencyRatios.size());
    const Eigen::Index modes = body.eigenvalues.size();
    const Eigen::Map<
        const Eigen::Matrix<std::complex<float>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>
        weights(table.weights.data(), rows, modes);
    std::vector<Eigen::VectorXcd> all;
    for (Eigen::Index first = 0, next = 0; first < modes; first = next) {
        while (next < modes && body.eigenvalues(next) <= body.eigenvalues(first) * (1 + 1e-9))
            ++next;
        const Eigen::MatrixXd shapes = body.shapes.middleCols(first, next - first);
        const Eigen::MatrixXcd own = weights.middleCols(first, next - first).cast<Complex>();
        all.emplace_back((shapes * own.transpose()).reshaped());
    }
    Eigen::MatrixXcd result(all.front().size(), all.size());
    for (std::size_t pole = 0; pole < all.size(); ++pole)
        result.col(static_cast<Eigen::Index>(pole)) = all[pole];
    return result;
}

struct TurnedBody {
    Body body;
    Eigen::Index turned = 0; ///< number of modes that share a pole
};

/// Returns the body with a random orthogonal basis for each set of equal poles.
TurnedBody withTurnedBases(const Body& body) {
    TurnedBody result{body};
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (Eigen::Index first = 0, next = 0; first < body.eigenvalues.size(); first = next) {
        while (next < body.eigenvalues.size() && body.eigenvalues(next) == body.eigenvalues(first))
            ++next;
        const Eigen::MatrixXd drawn = Eigen::MatrixXd::NullaryExpr(next - first, next - first,
                                                                   [&] { return normal(random); });
        const Eigen::MatrixXd rotation = drawn.householderQr().householderQ();
        result.body.shapes.middleCols(first, next - first) *= rotation;
        result.turned += next - first > 1 ? next - first : 0;
    }
    return result;
}

void checkSameResidues(const Body& body, const Body& other) {
    const Eigen::MatrixXcd expected = residues(body, body.radiation());
    const Eigen::MatrixXcd actual = residues(other, other.radiation());
    const double scale = expected.cwiseAbs().maxCoeff();
    CHECK(scale > 1e-2);
    CHECK((actual - expected).cwiseAbs().maxCoeff() < 1e-4 * scale);
    CHECK((other.shapes - body.shapes).cwiseAbs().maxCoeff() > 0.1);
}

/// Returns the mean square over the surface of the displacement along an axis.
double meanSquare(const Body& body, int mode, Eigen::Index axis) {
    const Eigen::VectorXd areas = vertexAreas(body.mesh);
    double sum = 0;
    for (Eigen::Index v = 0; v < body.mesh.vertexCount(); ++v)
        sum += areas(v) * std::pow(body.shapes(3 * v + axis, mode), 2);
    return sum / areas.sum();
}

/// Returns the modes of a flat sheet that move both long edges up and down together: no twist, no
/// sideways motion.
std::vector<int> bendingModes(const Body& sheet) {
    std::vector<int> modes;
    for (int mode = 0; mode < sheet.eigenvalues.size(); ++mode) {
        double twist = 0, size = 0;
        for (Eigen::Index v = 0; v < sheet.mesh.vertexCount(); ++v) {
            const double along = sheet.mesh.vertices(v, 0), across = sheet.mesh.vertices(v, 1);
            const double up = sheet.shapes(3 * v + 2, mode);
            twist += along * across * up;
            size += std::abs(along * across * up);
        }
        if (meanSquare(sheet, mode, 2) > 10 * meanSquare(sheet, mode, 1) &&
            std::abs(twist) < 0.1 * size)
            modes.push_back(mode);
    }
    return modes;
}

} // namespace

TEST_CASE("Pulsating, oscillating and oblate spheres radiate as in theory") {
    const auto method =
        GENERATE(RadiationMethod::preview, RadiationMethod::quick, RadiationMethod::exact);
    for (const int l : {0, 1, 2}) {
        auto body = sphere([l](const Eigen::Vector3d& n) -> Eigen::Vector3d {
            const double z = n.z();
            return (l == 0 ? 1 : l == 1 ? z : (3 * z * z - 1) / 2) * n;
        });
        const auto table = body.radiation(
            {.directions = alongZ, .frequencyRatios = sphereRatios, .method = method});
        for (std::size_t ratio = 0; ratio < sphereRatios.size(); ++ratio) {
            const double ka = sphereRatios[ratio];
            const auto expected = exactSphere(l, ka), actual = weight(table, 0, ratio, 0);
            INFO("l " << l << ", ka " << ka);
            // Weights between half octaves are interpolated.
            CHECK(std::abs(decibels(std::abs(actual / expected))) < (ka == 1 ? 0.5 : 0.8));
            CHECK(std::abs(std::arg(actual / expected)) < (ka == 1 ? 0.03 : 0.15));
        }
    }
}

TEST_CASE("Weights beyond the audible band equal those at its ends") {
    const auto body = sphere([](const Eigen::Vector3d& n) { return n; });
    const double highest = 2 * std::numbers::pi * 22000 / soundSpeed * radiusMetres;
    const double lowest = highest * 20 / 22000;
    const auto table = body.radiation({alongZ, {lowest / 9, lowest, highest, 16, 32}});
    const auto at = [&](std::size_t ratio) { return weight(table, 0, ratio, 0); };
    CHECK(std::abs(at(0) - at(1)) < 1e-6 * std::abs(at(1)));
    CHECK(std::abs(at(2) - at(3)) < 1e-6 * std::abs(at(3)));
    CHECK(at(3) == at(4));
}

TEST_CASE("A shift of the centre only delays the radiation") {
    const std::vector<double> ratios{1};
    auto body = sphere([](const Eigen::Vector3d& n) -> Eigen::Vector3d {
        return (1 + n.x() + 2 * n.z() * n.z() * n.z() + n.x() * n.y()) * n;
    });
    const auto here = body.radiation({stereoDirections(), ratios});
    body.centreMetres = {0.06, -0.02, 0.05};
    const auto there = body.radiation({stereoDirections(), ratios});
    for (std::size_t direction = 0; direction < 2; ++direction)
        for (std::size_t ratio = 0; ratio < ratios.size(); ++ratio) {
            const double waveNumber = ratios[ratio] / radiusMetres;
            const auto later =
                std::polar(1.0, waveNumber * stereoDirections()[direction].dot(body.centreMetres));
            const auto expected = weight(here, direction, ratio, 0);
            CHECK(std::abs(weight(there, direction, ratio, 0) * later - expected) <
                  1e-5 * std::abs(expected));
        }
}

TEST_CASE("Some direction lies within 30 degrees of any listener, and the first two are the stereo "
          "pair") {
    const auto directions = directionsAllAround();
    CHECK(directions[0] == stereoDirections()[0]);
    CHECK(directions[1] == stereoDirections()[1]);
    const Mesh sphere = icosphereMesh(1, 4);
    for (const auto& listener : sphere.vertices.rowwise()) {
        double nearest = 0;
        for (const auto& direction : directions) {
            CHECK_THAT(direction.norm(), WithinAbs(1, 1e-12));
            nearest = std::max(nearest, direction.dot(listener.transpose()));
        }
        CHECK(nearest > std::cos(30 * std::numbers::pi / 180));
    }
}

TEST_CASE("An oscillating sphere is silent all around its equator") {
    const auto body = sphere([](const auto& normal) { return normal.z() * normal; });
    const auto table = body.radiation({directionsAllAround(), {0.5}});
    const std::array<float, 3> above{0, 0, 2}, below{0, 0, -1}, beside{5, 0, 0};
    const auto at = [&](const auto& listener) {
        return std::abs(weight(table, *table.directionTowards(listener), 0, 0));
    };
    CHECK_THAT(at(above), WithinRel(at(below), 1e-3));
    CHECK(at(beside) < 2e-3 * at(above));
}

TEST_CASE("A bar's fundamental is audible although its two faces together displace no volume") {
    const auto bar = analysed(sheetMesh(0.385, 0.04, 929), 0.02, 3000);
    const auto bending = bendingModes(bar);
    REQUIRE(bending.size() >= 2);
    const auto table = bar.radiation();
    constexpr std::size_t asAnalysed = 4;
    REQUIRE(table.frequencyRatios[asAnalysed] == 1);
    const double rms = std::sqrt(meanSquare(bar, bending[0], 2));
    for (std::size_t direction = 0; direction < 2; ++direction) {
        const auto first = weight(table, direction, asAnalysed, bending[0]),
                   second = weight(table, direction, asAnalysed, bending[1]);
        // A piston of the bar's face in an infinite wall: ωρ0/2π times area and velocity.
        const double piston =
            std::sqrt(bar.eigenvalues(bending[0])) * 1.204 / (2 * std::numbers::pi) * 0.0154 * rms;
        CHECK(decibels(std::abs(first) / piston) > -40);
        CHECK(std::abs(second) > std::abs(first));
        CHECK(decibels(std::abs(second / first)) < 25);
    }
}

TEST_CASE("The sum of both channels keeps every mode below 3 kHz of a mirror-symmetric bar") {
    const auto bar = analysed(sheetMesh(0.3, 0.04, 400), 0.02, 12000);
    const auto table = bar.radiation();
    const auto found = std::ranges::find(table.frequencyRatios, 1.0);
    REQUIRE(found != table.frequencyRatios.end());
    const auto ratio = static_cast<std::size_t>(found - table.frequencyRatios.begin());
    int heard = 0;
    for (int mode = 0; mode < bar.eigenvalues.size(); ++mode) {
        if (std::sqrt(bar.eigenvalues(mode)) > 2 * std::numbers::pi * 3000)
            continue;
        const auto left = weight(table, 0, ratio, mode), right = weight(table, 1, ratio, mode);
        INFO("mode " << mode);
        CHECK(std::abs(left + right) > 0.9 * (std::abs(left) + std::abs(right)));
        ++heard;
    }
    CHECK(heard >= 3);
}

TEST_CASE("A strike sounds the same for any signs of the shapes") {
    auto body = analysed(sheetMesh(0.3, 0.1, 300), 0.01, 8000);
    const auto before = residues(body, body.radiation());
    for (Eigen::Index mode = 0; mode < body.eigenvalues.size(); mode += 2)
        body.shapes.col(mode) *= -1;
    const auto after = residues(body, body.radiation());
    CHECK(before == after);
    CHECK(before.cwiseAbs().maxCoeff() > 1e-2);
}

TEST_CASE("A strike sounds the same for any basis of equal poles") {
    const auto mesh = GENERATE(hoopMesh(0.07, 0.015, 48, 4), icosphereMesh(0.05, 2));
    auto body = analysed(mesh, 0.004, 30000);
    // Makes the eigenvalues of pairs equal. Mesh and solver leave a rounding error between them.
    for (Eigen::Index mode = 1; mode < body.eigenvalues.size(); ++mode)
        if (body.eigenvalues(mode) < body.eigenvalues(mode - 1) * (1 + 1e-7))
            body.eigenvalues(mode) = body.eigenvalues(mode - 1);
    REQUIRE(withTurnedBases(body).turned >= 8);
    checkSameResidues(body, withTurnedBases(body).body);
}

TEST_CASE("A strike sounds the same for any basis of equal poles with weights in quadrature") {
    // Even and odd modes along a sheet have imaginary and real weights. Give three modes one pole.
    auto body = analysed(sheetMesh(0.3, 0.1, 300), 0.01, 8000);
    body.centreMetres = {0.02, 0.01, 0.03};
    for (Eigen::Index mode = 0; mode < body.eigenvalues.size(); ++mode)
        body.eigenvalues(mode) = body.eigenvalues(mode / 3 * 3);
    checkSameResidues(body, withTurnedBases(body).body);
}

TEST_CASE("An open surface needs a thickness to radiate") {
    auto open = sphere([](const Eigen::Vector3d& n) { return n; });
    CHECK(radiationOf({open.mesh, open.shapes, open.eigenvalues}));
    open.mesh.faces.conservativeResize(open.mesh.faceCount() - 1, 3);
    const auto refused = radiationOf({open.mesh, open.shapes, open.eigenvalues});
    REQUIRE_FALSE(refused);
    CHECK_THAT(refused.error().message, ContainsSubstring("needs a thickness"));
}

TEST_CASE("Radiation does not depend on the number of threads") {
    const auto plate = analysed(sheetMesh(0.3, 0.2, 150), 0.005, 3000);
    const auto one = plate.radiation({.threads = 1}), three = plate.radiation({.threads = 3});
    CHECK(one == three);
}

TEST_CASE("Radiation reports its progress and stops when cancelled") {
    const auto plate = analysed(sheetMesh(0.3, 0.2, 150), 0.005, 3000);
    std::atomic<bool> cancelled = false;
    double last = 0;
    bool falls = false;
    const auto run = [&] {
        return radiationOf({plate.mesh, plate.shapes, plate.eigenvalues, plate.thicknessMetres}, {},
                           {.progress =
                                [&](double fraction, std::string_view) {
                                    falls = falls || fraction < last;
                                    last = fraction;
                                },
                            .cancelled = &cancelled});
    };
    REQUIRE(run());
    CHECK(last > 0.5);
    CHECK_FALSE(falls);
    cancelled = true;
    const auto stopped = run();
    REQUIRE_FALSE(stopped);
    CHECK(isCancellation(stopped.error()));
}

TEST_CASE("The pressure near a sphere matches theory") {
    const auto body = sphere([](const Eigen::Vector3d& n) { return n; });
    RadiationSettings settings{.directions = alongZ, .frequencyRatios = {1}};
    for (const double radii : {1.01, 1.2, 3.0})
        settings.nearPointsMetres.push_back(radii * radiusMetres *
                                            Eigen::Vector3d(1, 2, 3).normalized());
    const auto radiation = radiationOf({body.mesh, body.shapes, body.eigenvalues}, settings);
    REQUIRE(radiation);
    for (Eigen::Index point = 0; point < 3; ++point) {
        const double distance = settings.nearPointsMetres[static_cast<std::size_t>(point)].norm();
        const Complex expected =
            exactSphere(0, 1) / distance * std::polar(1.0, -distance / radiusMetres);
        CHECK(std::abs(radiation->nearPressures(point, 0) - expected) < 0.03 * std::abs(expected));
    }
}

TEST_CASE("The quick radiation of a plate's modes is within 4 dB of the exact method") {
    const auto plate = analysed(sheetMesh(0.3, 0.2, 600), 0.003, 6000);
    const auto modes = plate.eigenvalues.size();
    REQUIRE(modes > 20);
    const RadiationSettings quick{.directions = directionsAllAround(), .frequencyRatios = {1}};
    RadiationSettings exact = quick;
    exact.method = RadiationMethod::exact;
    const auto fast = plate.radiation(quick), slow = plate.radiation(exact);
    double squares = 0;
    for (int mode = 0; mode < modes; ++mode) {
        double fastPower = 0, slowPower = 0;
        for (std::size_t direction = 0; direction < quick.directions.size(); ++direction) {
            fastPower += std::norm(weight(fast, direction, 0, mode));
            slowPower += std::norm(weight(slow, direction, 0, mode));
        }
        squares += std::pow(10 * std::log10(fastPower / slowPower), 2);
    }
    CHECK(std::sqrt(squares / static_cast<double>(modes)) < 4);
}

TEST_CASE("A mesh folded flat still has finite radiation") {
    auto body = sphere([](const Eigen::Vector3d& n) { return n; });
    body.mesh.vertices.col(2).setZero();
    for (const auto& weight : body.radiation().weights)
        CHECK((std::isfinite(weight.real()) && std::isfinite(weight.imag())));
}
