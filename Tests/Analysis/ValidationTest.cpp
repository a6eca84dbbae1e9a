// Compares models with theory, case by case, for the tables of docs/validation.md. The theory comes
// from the page's sources. Modes are identified by shape or by order.
#include "Analysis/TimoshenkoBeam.h"
#include "Geometry/ParametricMesh.h"
#include "Geometry/Remesh.h"
#include "SolvedBody.h"
#include "Support/GeneratedMeshes.h"
#include "TestMaterials.h"
#include "ValidationTable.h"

#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double youngs = 20e9, density = 1000; // as in referenceWood

struct NamedValue {
    std::string mode;
    double value = 0;
};

/// Returns √(D/ρh)/2πa², the frequency unit of plates.
double plateUnitHz(double lengthMetres, double thicknessMetres, double poissonRatio) {
    const double rigidity =
        youngs * std::pow(thicknessMetres, 3) / (12 * (1 - poissonRatio * poissonRatio));
    return std::sqrt(rigidity / (density * thicknessMetres)) /
           (2 * pi * lengthMetres * lengthMetres);
}

/// Returns the lowest modes of a body in theory's order.
std::vector<ValidationRow>
inOrder(const std::vector<double>& foundHz, const std::vector<NamedValue>& theory, double unitHz) {
    REQUIRE(foundHz.size() >= theory.size());
    std::vector<ValidationRow> rows;
    for (std::size_t i = 0; i < theory.size(); ++i)
        rows.push_back({theory[i].mode, theory[i].value * unitHz, foundHz[i]});
    return rows;
}

/// Returns displacement and slope of the mode with this β L of a thin free or clamped beam.
Field beamBending(double betaL, double lengthMetres, bool clamped) {
    const double ch = std::cosh(betaL), sh = std::sinh(betaL), c = std::cos(betaL),
                 s = std::sin(betaL);
    const double ratio = clamped ? (ch + c) / (sh + s) : (ch - c) / (sh - s);
    const double sign = clamped ? -1 : 1;
    return [=](const Eigen::Vector3d& p) {
        const double beta = betaL / lengthMetres, x = beta * (p.x() + lengthMetres / 2);
        const double w =
            std::cosh(x) + sign * std::cos(x) - ratio * (std::sinh(x) + sign * std::sin(x));
        const double slope =
            std::sinh(x) - sign * std::sin(x) - ratio * (std::cosh(x) + sign * std::cos(x));
        return Eigen::Vector3d(-p.z() * beta * slope, 0, w);
    };
}

constexpr std::array freeBetaL{4.73004075, 7.85320462, 10.99560784, 14.13716549, 17.27875966};
constexpr std::array clampedBetaL{1.87510407, 4.69409113, 7.85475744, 10.99554074, 14.13716839};

std::vector<ValidationRow> bendingRows(const SolvedBody& body,
                                       const std::vector<double>& theoryHz,
                                       double length,
                                       bool clamped) {
    std::vector<ValidationRow> rows;
    for (std::size_t i = 0; i < theoryHz.size(); ++i) {
        const double betaL = clamped ? clampedBetaL[i] : freeBetaL[i];
        rows.push_back({"bending " + std::to_string(i + 1), theoryHz[i],
                        frequencyLikeHz(body, beamBending(betaL, length, clamped))});
    }
    return rows;
}

const std::vector<double> timoshenkoHz{569.6, 1545.4, 2963.4, 4765.2, 6894.6};

const std::vector<NamedValue> squarePlate030{{"1", 13.4682}, {"2", 19.5961}, {"3", 24.2702},
                                             {"4", 34.8009}, {"5", 34.8009}, {"6", 61.0932},
                                             {"7", 61.0932}, {"8", 63.6861}};
const std::vector<NamedValue> circularPlate030{
    {"(2,0)", 5.3583},  {"(2,0)", 5.3583},  {"(0,1)", 9.0031},  {"(3,0)", 12.4390},
    {"(3,0)", 12.4390}, {"(1,1)", 20.4746}, {"(1,1)", 20.4746}, {"(4,0)", 21.8352},
    {"(4,0)", 21.8352}, {"(5,0)", 33.4949}, {"(5,0)", 33.4949}, {"(2,1)", 35.2601},
    {"(2,1)", 35.2601}, {"(0,2)", 38.4432}};

double hoppeUnitHz(double radius, double thickness) {
    return std::sqrt(youngs / (12 * density)) * thickness / (2 * pi * radius * radius);
}

const std::vector<NamedValue> hoppe{{"n = 2", 2.68328}, {"n = 2", 2.68328},  {"n = 3", 7.58947},
                                    {"n = 3", 7.58947}, {"n = 4", 14.55214}, {"n = 4", 14.55214}};

std::vector<double> cantileverHz(double length, double thickness) {
    std::vector<double> result;
    for (const double betaL : clampedBetaL)
        result.push_back(betaL * betaL * thickness * std::sqrt(youngs / (12 * density)) /
                         (2 * pi * length * length));
    return result;
}

/// Returns √(E/ρ(1 − ν²))/2πR, the frequency unit of spherical membranes.
double sphereUnitHz(double radius, double poissonRatio) {
    return std::sqrt(youngs / (density * (1 - poissonRatio * poissonRatio))) / (2 * pi * radius);
}

/// Returns the lowest and highest of each family of 2l + 1 modes.
std::vector<ValidationRow>
sphereRows(const std::vector<double>& foundHz, const std::vector<double>& theory, double unitHz) {
    std::vector<ValidationRow> rows;
    std::size_t first = 0;
    for (std::size_t i = 0; i < theory.size(); ++i) {
        const std::size_t l = i + 2, last = first + 2 * l;
        REQUIRE(foundHz.size() > last);
        const std::string name = "l = " + std::to_string(l);
        rows.push_back({name + ", lowest", theory[i] * unitHz, foundHz[first]});
        rows.push_back({name + ", highest", theory[i] * unitHz, foundHz[last]});
        first = last + 1;
    }
    return rows;
}

} // namespace

TEST_CASE("A free bar of finite elements has five bending modes within 1 % of Timoshenko",
          "[validation]") {
    const auto body = solvedSolid(extrudedMesh(sheetMesh(0.4, 0.05, SheetGrid{36, 4}), 0.02, 2),
                                  elasticLaw(referenceWood(0.25)), density, 0.0115,
                                  {.lowestHz = 20, .highestHz = 7200});
    report("Free bar, finite elements", 0.01, body, bendingRows(body, timoshenkoHz, 0.4, false));
}

TEST_CASE("A free bar of two-layer springs has five bending modes within 3 % of Timoshenko",
          "[validation]") {
    const auto body = solvedShell(sheetMesh(0.4, 0.05, 600), referenceWood(0.25), 0.02,
                                  {.lowestHz = 20, .highestHz = 7500});
    report("Free bar, two-layer springs", 0.03, body, bendingRows(body, timoshenkoHz, 0.4, false));
}

TEST_CASE("A free square plate of finite elements has eight modes within 2 % of Ritz",
          "[validation]") {
    const double unit = plateUnitHz(1, 0.02, 0.3);
    const auto body =
        solvedSolid(extrudedMesh(sheetMesh(1, 1, 300), 0.02), elasticLaw(referenceWood(0.3)),
                    density, 0.07, {.lowestHz = unit, .highestHz = 66 * unit});
    report("Free square plate, finite elements", 0.02, body,
           inOrder(frequenciesHz(body), squarePlate030, unit));
}

TEST_CASE("A free square plate remeshed like a user's has eight modes within 2 % of Ritz",
          "[validation]") {
    const double unit = plateUnitHz(1, 0.02, 0.3);
    const auto surface = remesh(boxMesh({1, 1, 0.02}, {1, 1, 1}), 0.07);
    REQUIRE(surface);
    const auto body = solvedSolid(*surface, elasticLaw(referenceWood(0.3)), density, 0.07,
                                  {.lowestHz = unit, .highestHz = 66 * unit});
    report("Free square plate as a user's mesh is cut, finite elements", 0.02, body,
           inOrder(frequenciesHz(body), squarePlate030, unit));
}

TEST_CASE("A free square plate of two-layer springs has eight modes within 3 % of Ritz at nu = 1/3",
          "[validation]") {
    const double unit = plateUnitHz(1, 0.02, 1.0 / 3);
    const auto body = solvedShell(sheetMesh(1, 1, 1074), referenceWood(1.0 / 3), 0.02,
                                  {.lowestHz = unit, .highestHz = 66 * unit});
    report("Free square plate, two-layer springs", 0.03, body,
           inOrder(frequenciesHz(body),
                   {{"1", 13.1655},
                    {"2", 19.2200},
                    {"3", 24.4243},
                    {"4", 34.2267},
                    {"5", 34.2267},
                    {"6", 60.9304},
                    {"7", 60.9304},
                    {"8", 62.7477}},
                   unit));
}

TEST_CASE("A free 1.5 : 1 plate of finite elements has six modes within 2 % of Ritz",
          "[validation]") {
    const double unit = plateUnitHz(1.5, 0.02, 0.3);
    const auto body =
        solvedSolid(extrudedMesh(sheetMesh(1.5, 1, 330), 0.02), elasticLaw(referenceWood(0.3)),
                    density, 0.08, {.lowestHz = unit, .highestHz = 70 * unit});
    report("Free plate of 1.5 to 1, finite elements", 0.02, body,
           inOrder(frequenciesHz(body),
                   {{"1", 20.0955},
                    {"2", 21.4133},
                    {"3", 46.347},
                    {"4", 49.9099},
                    {"5", 57.7135},
                    {"6", 67.0297}},
                   unit));
}

TEST_CASE("A free circular plate of finite elements has fourteen modes within 2 % of theory",
          "[validation]") {
    const double unit = plateUnitHz(1, 0.04, 0.3);
    const auto body =
        solvedSolid(extrudedMesh(discMesh(1, 10), 0.04), elasticLaw(referenceWood(0.3)), density,
                    0.1, {.lowestHz = unit, .highestHz = 39.5 * unit});
    report("Free circular plate, finite elements", 0.02, body,
           inOrder(frequenciesHz(body), circularPlate030, unit));
}

TEST_CASE("A circular plate of finite elements, 1/50 of its radius thick, is within 2 % of theory",
          "[validation]") {
    const double unit = plateUnitHz(1, 0.02, 0.3);
    const auto body =
        solvedSolid(extrudedMesh(discMesh(1, 12), 0.02), elasticLaw(referenceWood(0.3)), density,
                    0.085, {.lowestHz = unit, .highestHz = 39.5 * unit});
    report("Free circular plate of half the thickness, finite elements", 0.02, body,
           inOrder(frequenciesHz(body), circularPlate030, unit));
}

TEST_CASE("A free circular plate of two-layer springs is within 3 % of theory at nu = 1/3",
          "[validation]") {
    const double unit = plateUnitHz(1, 0.04, 1.0 / 3);
    const auto body = solvedShell(discMesh(1, 18), referenceWood(1.0 / 3), 0.04,
                                  {.lowestHz = unit, .highestHz = 23 * unit});
    report("Free circular plate, two-layer springs", 0.03, body,
           inOrder(frequenciesHz(body),
                   {{"(2,0)", 5.2511},
                    {"(2,0)", 5.2511},
                    {"(0,1)", 9.0761},
                    {"(3,0)", 12.2216},
                    {"(3,0)", 12.2216},
                    {"(1,1)", 20.5173},
                    {"(1,1)", 20.5173},
                    {"(4,0)", 21.4919},
                    {"(4,0)", 21.4919}},
                   unit));
}

TEST_CASE("A ring of finite elements has pairs of in-plane modes within 2 % of Hoppe",
          "[validation]") {
    const double thickness = 0.05, unit = hoppeUnitHz(1, thickness);
    const auto surface =
        extrudedMesh(annulusMesh(1 - thickness / 2, 1 + thickness / 2, 80, 1), thickness);
    const auto body = solvedSolid(surface, elasticLaw(referenceWood(0.3)), density, 0.08,
                                  {.lowestHz = unit, .highestHz = 15.5 * unit});
    report("Ring in its plane, finite elements", 0.02, body,
           inOrder(inPlaneFrequenciesHz(body), hoppe, unit));
}

TEST_CASE("A ring of two-layer springs has pairs of in-plane modes within 3 % of Hoppe",
          "[validation]") {
    const double radius = 0.1, thickness = 0.003, unit = hoppeUnitHz(radius, thickness);
    const auto body = solvedShell(hoopMesh(radius, 0.006, 360, 4), referenceWood(1.0 / 3),
                                  thickness, {.lowestHz = unit, .highestHz = 16 * unit});
    report("Ring in its plane, two-layer springs", 0.03, body,
           inOrder(inPlaneFrequenciesHz(body), hoppe, unit));
}

TEST_CASE("A cantilever of finite elements has five bending modes within 1 % of beam theory",
          "[validation]") {
    const auto theory = cantileverHz(0.4, 0.004);
    const auto body = solvedSolid(extrudedMesh(sheetMesh(0.4, 0.01, SheetGrid{60, 2}), 0.004),
                                  elasticLaw(referenceWood(0.3)), density, 0.0067,
                                  {.lowestHz = 1, .highestHz = 1.1 * theory[4]},
                                  [](const Eigen::Vector3d& p) { return p.x() < -0.2 + 1e-9; });
    report("Cantilever, finite elements", 0.01, body, bendingRows(body, theory, 0.4, true));
}

TEST_CASE("A cantilever of two-layer springs has five bending modes within 3 % of beam theory",
          "[validation]") {
    const auto theory = cantileverHz(0.4, 0.004);
    const auto body = solvedShell(sheetMesh(0.4, 0.01, SheetGrid{120, 4}), referenceWood(0.3),
                                  0.004, {.lowestHz = 1, .highestHz = 1.1 * theory[4]},
                                  [](const Eigen::Vector3d& p) { return p.x() < -0.2 + 1e-9; });
    report("Cantilever, two-layer springs", 0.03, body, bendingRows(body, theory, 0.4, true));
}

TEST_CASE(
    "A square cantilever plate of finite elements has six modes within 2 % of published figures",
    "[validation]") {
    const double unit = plateUnitHz(1, 0.01, 0.3);
    const auto body =
        solvedSolid(extrudedMesh(sheetMesh(1, 1, 400), 0.01), elasticLaw(referenceWood(0.3)),
                    density, 0.055, {.lowestHz = unit, .highestHz = 57 * unit},
                    [](const Eigen::Vector3d& p) { return p.x() < -0.5 + 1e-9; });
    report("Square cantilever plate, finite elements", 0.02, body,
           inOrder(
               frequenciesHz(body),
               {{"1", 3.492}, {"2", 8.525}, {"3", 21.43}, {"4", 27.33}, {"5", 31.11}, {"6", 54.44}},
               unit));
}

TEST_CASE("A round bar of finite elements stretches and twists within 1 % of theory",
          "[validation]") {
    const double length = 0.4, radius = 0.01;
    const auto material = referenceWood(0.3);
    const double shear = youngs / (2 * 1.3);
    const auto body =
        solvedSolid(extrudedMesh(discMesh(radius, 2), length, 60), elasticLaw(material), density,
                    0.007, {.lowestHz = 20, .highestHz = 11300});
    std::vector<ValidationRow> rows;
    const auto wave = [&](int n, const Eigen::Vector3d& p) {
        return std::cos(n * pi * (p.z() / length + 0.5));
    };
    for (const int n : {1, 2})
        rows.push_back({"stretch " + std::to_string(n),
                        n / (2 * length) * std::sqrt(youngs / density),
                        frequencyLikeHz(body, [&](const Eigen::Vector3d& p) {
                            return Eigen::Vector3d(0, 0, wave(n, p));
                        })});
    for (const int n : {1, 2, 3})
        rows.push_back({"twist " + std::to_string(n), n / (2 * length) * std::sqrt(shear / density),
                        frequencyLikeHz(body, [&](const Eigen::Vector3d& p) {
                            return Eigen::Vector3d(-p.y() * wave(n, p), p.x() * wave(n, p), 0);
                        })});
    report("Stretch and twist of a round bar, finite elements", 0.01, body, rows);
}

TEST_CASE("A hollow sphere of finite elements has l = 2 within 2 % of the membrane",
          "[validation]") {
    const double unit = sphereUnitHz(0.1, 0.3);
    const auto body = solvedSolid(hollowSphereMesh(0.1, 0.002, 3), elasticLaw(referenceWood(0.3)),
                                  density, 0.015, {.lowestHz = 20, .highestHz = 0.75 * unit});
    report("Hollow sphere, finite elements", 0.02, body,
           sphereRows(frequenciesHz(body), {0.70094}, unit));
}

TEST_CASE("A hollow sphere of two-layer springs has l = 2 to 4 within 3 % of the membrane",
          "[validation]") {
    const double unit = sphereUnitHz(0.1, 1.0 / 3);
    const auto body = solvedShell(icosphereMesh(0.1, 3), referenceWood(1.0 / 3), 0.001,
                                  {.lowestHz = 20, .highestHz = 0.9 * unit});
    report("Hollow sphere, two-layer springs", 0.03, body,
           sphereRows(frequenciesHz(body), {0.68726, 0.81650, 0.86778}, unit));
}

namespace {

void checkWoodenBar(const std::string& title,
                    const Eigen::Vector3d& grain,
                    double youngsModulusPa,
                    double shearModulusPa) {
    const double side = 0.02, area = side * side, second = area * side * side / 12;
    std::vector<double> places;
    for (int i = 0; i <= 48; ++i)
        places.push_back(0.4 * i / 48);
    const auto theory = freeBeamFrequenciesHz(
        places,
        [&](double) {
            return BeamSection{.bendingStiffnessNM2 = youngsModulusPa * second,
                               .shearStiffnessN = 5.0 / 6 * shearModulusPa * area,
                               .massKgPerM = 700 * area,
                               .rotaryInertiaKgM = 700 * second};
        },
        4);
    const auto law = elasticLaw(roundWood, {.grain = grain, .radial = Eigen::Vector3d::UnitZ()});
    const auto body = solvedSolid(extrudedMesh(sheetMesh(0.4, side, SheetGrid{40, 2}), side, 2),
                                  law, 700, 0.01, {.lowestHz = 20, .highestHz = 1.2 * theory[3]});
    report(title, 0.01, body, bendingRows(body, theory, 0.4, false));
}

} // namespace

TEST_CASE(
    "A wooden bar along the grain has four bending modes within 1 % of Timoshenko (E_L, G_LR)",
    "[validation]") {
    checkWoodenBar("Wooden bar along the grain, finite elements", Eigen::Vector3d::UnitX(), 16e9,
                   1.2e9);
}

TEST_CASE(
    "A wooden bar across the grain has four bending modes within 1 % of Timoshenko (E_T, G_RT)",
    "[validation]") {
    checkWoodenBar("Wooden bar across the grain, finite elements", Eigen::Vector3d::UnitY(), 1e9,
                   0.3e9);
}

TEST_CASE("Every section of docs/validation.md has a case", "[validation]") {
    constexpr std::size_t cases = 19; // each requires its section
    CHECK(validationSections() == cases);
}
