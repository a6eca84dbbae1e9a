#include "Analysis/MaterialFit.h"

#include "Geometry/ParametricMesh.h"
#include "Support/GeneratedMeshes.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>
#include <random>

using namespace idiophone;
using namespace idiophone::test;

namespace {

AnalysisSettings settings(const Material& material) {
    return {.name = "thing",
            .source = "thing.obj",
            .material = material,
            .thicknessMetres = 0.003,
            .maxFrequencyHz = 14000,
            .listeningDirections = {}};
}

const Material unknown{.name = "Unknown",
                       .youngsModulusPa = 31e9,
                       .densityKgPerM3 = 2100,
                       .poissonRatio = 0.22,
                       .damping = {.fluidPerSecond = 4, .lossFactor = 0.003},
                       .source = {}};

/// The modes of a strike at a vertex, with errors of measurement: frequencies by 2 cents, decays by
/// 5 %, no mode 50 dB below the strongest, and false modes.
std::vector<MeasuredMode> recorded(const ModalObject& object, std::size_t row) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> even(-1, 1);
    std::vector<MeasuredMode> modes;
    const auto shapes = object.shapesAt(row);
    for (std::size_t mode = 0; mode < object.modeCount(); ++mode)
        if (object.dampedFrequencyHz(mode) < 9000)
            modes.push_back({object.dampedFrequencyHz(mode) * (1 + 0.001 * even(random)),
                             object.decayPerSecond(mode) * (1 + 0.05 * even(random)),
                             {std::pow(double(shapes[3 * mode + 2]), 2)}});
    const double strongest = std::ranges::max(modes, {}, [](const MeasuredMode& mode) {
                                 return mode.amplitudes[0];
                             }).amplitudes[0];
    std::erase_if(modes, [&](const MeasuredMode& mode) {
        return mode.amplitudes[0] < strongest * std::pow(10, -50.0 / 20);
    });
    for (const double hz : {97.0, 3333.0, 7777.0})
        modes.push_back({hz, 60, {0.02 * strongest}});
    std::ranges::sort(modes, {}, &MeasuredMode::frequencyHz);
    return modes;
}

double ratioOf(const Material& material) {
    return material.youngsModulusPa / material.densityKgPerM3;
}

void checkFit(const Mesh& mesh, const Material& material) {
    const auto object = analyse(mesh, settings(material));
    REQUIRE(object);
    const auto modes = recorded(*object, object->shapeVertexCount() / 7);
    const auto fit = fitMaterial(modes, mesh, settings({}));
    INFO(material.name << ", " << modes.size() << " modes");
    REQUIRE((fit && *fit));
    const auto& found = **fit;
    CAPTURE(found.resembles, found.matched);
    CHECK(std::abs(ratioOf(found.material) / ratioOf(material) - 1) < 0.05);
    for (const double hz : {500.0, 2000.0, 8000.0}) {
        const double eigenvalue = std::pow(2 * std::numbers::pi * hz, 2);
        CHECK(std::abs(found.material.damping.perSecond(eigenvalue) /
                           material.damping.perSecond(eigenvalue) -
                       1) < 0.2);
    }
}

} // namespace

TEST_CASE("A material is fitted to the modes of a bar, a plate and a ring", "[.weekly]") {
    const std::array<Mesh, 3> meshes{extrudedMesh(sheetMesh(0.25, 0.04, 300), 0.012, 3),
                                     sheetMesh(0.3, 0.21, 1200), hoopMesh(0.08, 0.05, 120, 10)};
    const std::array<Material, 3> materials{*findMaterial("Aluminium"), *findMaterial("Glass"),
                                            unknown};
    for (std::size_t i = 0; i < meshes.size(); ++i)
        checkFit(meshes[i], materials[i]);
}

TEST_CASE("Modes match those of an object at one ratio only") {
    std::vector<double> bar; // free: ratios of Euler and Bernoulli
    for (const double root : {4.730, 7.853, 10.996, 14.137, 17.279})
        bar.push_back(440 * root * root / (4.730 * 4.730));
    std::vector<MeasuredMode> measured;
    for (const double hz : bar)
        measured.push_back({0.61 * hz, 20, {1}});
    const auto match = matchModes(measured, bar);
    REQUIRE(match);
    CHECK(std::abs(match->frequencyRatio / 0.61 - 1) < 1e-3);
    CHECK(match->matched.size() == 5);
    CHECK_FALSE(match->other);
    // A harmonic series is not a bar.
    for (std::size_t i = 0; i < measured.size(); ++i)
        measured[i].frequencyHz = 300 * double(i + 1);
    CHECK_FALSE(matchModes(measured, bar));
    CHECK_FALSE(matchModes(std::span(measured).first(1), bar));
}

TEST_CASE(
    "Without a mesh the damping alone is fitted, and the rest is the most similar material's") {
    std::vector<MeasuredMode> modes;
    const auto& porcelain = *findMaterial("Porcelain");
    for (const double hz : {400.0, 1100.0, 2500.0, 6000.0})
        modes.push_back(
            {hz, porcelain.damping.perSecond(std::pow(2 * std::numbers::pi * hz, 2)) / 2, {1}});
    const auto fit = fitDampingOnly(modes);
    REQUIRE(fit);
    CHECK(std::abs(fit->material.damping.lossFactor / porcelain.damping.lossFactor - 1) < 0.01);
    CHECK(fit->material.youngsModulusPa == findMaterial(fit->resembles)->youngsModulusPa);
    CHECK_FALSE(fitDampingOnly({}));
}

TEST_CASE("Modes that are not of the mesh give no material") {
    std::vector<MeasuredMode> noise;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> hz(200, 9000);
    for (int i = 0; i < 12; ++i)
        noise.push_back({hz(random), 30, {1}});
    std::ranges::sort(noise, {}, &MeasuredMode::frequencyHz);
    const auto fit =
        fitMaterial(noise, extrudedMesh(sheetMesh(0.25, 0.04, 300), 0.012, 3), settings({}));
    REQUIRE(fit);
    CHECK_FALSE(*fit);
}
