// Tests the stored tines, rods and chimes against theory.
#include "Analysis/BarTuning.h"
#include "Analysis/FactoryBars.h"
#include "Analysis/ModalAnalysis.h"
#include "Analysis/Pitch.h"
#include "Mesh/ObjectMesh.h"
#include "StoredObject.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

double hertz(const ModalObject& object, std::size_t mode) {
    return std::sqrt(object.eigenvalues[mode]) / (2 * std::numbers::pi);
}

double extentMetres(const ModalObject& object, int axis) {
    const Mesh mesh = objectMesh(object);
    return mesh.vertices.col(axis).maxCoeff() - mesh.vertices.col(axis).minCoeff();
}

double t60Seconds(const ModalObject& object, std::size_t mode) {
    return std::log(1000) / object.decayPerSecond(mode);
}

} // namespace

TEST_CASE("Teeth of the music box have the two lowest partials of a cantilever within 1 %") {
    const auto* comb = findBarInstrument("music-box");
    REQUIRE(comb != nullptr);
    for (int note = comb->lowestNote; note <= comb->highestNote; ++note) {
        const auto tooth = stored(comb->barName(note));
        CHECK_FALSE(tooth.clampedVertices.empty());
        const double length = extentMetres(tooth, 0), height = extentMetres(tooth, 2);
        const double speed =
            std::sqrt(tooth.material.youngsModulusPa / tooth.material.densityKgPerM3);
        const auto bending = verticalBendingModes(tooth);
        for (const std::size_t partial : {0, 1}) {
            constexpr std::array betaLengths{1.87510407, 4.69409113};
            const double wantedHz = std::pow(betaLengths[partial] / length, 2) * height * speed /
                                    std::sqrt(12.0) / (2 * std::numbers::pi);
            INFO(tooth.name << ", partial " << partial);
            CHECK_THAT(hertz(tooth, static_cast<std::size_t>(bending.at(partial))),
                       WithinRel(wantedHz, 0.01));
        }
        CHECK(t60Seconds(tooth, 0) > 0.3);
        CHECK(t60Seconds(tooth, 0) < 6);
    }
}

TEST_CASE("A kalimba's second partial is 5.4 to 6.4 times its first, as on measured ones") {
    const auto* kalimba = findBarInstrument("kalimba");
    REQUIRE(kalimba != nullptr);
    for (int note = kalimba->lowestNote; note <= kalimba->highestNote; ++note) {
        const auto tine = stored(kalimba->barName(note));
        const auto bending = verticalBendingModes(tine);
        const auto first = static_cast<std::size_t>(bending.at(0)),
                   second = static_cast<std::size_t>(bending.at(1));
        const double ratio = hertz(tine, second) / hertz(tine, first);
        INFO(tine.name << ": " << ratio);
        CHECK((ratio > 5.4 && ratio < 6.4)); // Chapman, JASA 131, 945 (2012)
        CHECK((t60Seconds(tine, first) > 0.3 && t60Seconds(tine, first) < 2));
        CHECK(t60Seconds(tine, second) < t60Seconds(tine, first) / 4);
    }
}

TEST_CASE("A tuning fork rings in the mode of opposite prongs, within 1 % of a finer analysis") {
    const auto fork = stored("tuning-fork");
    // Both prongs to one side, which the stem ends at once, come before the principal mode.
    CHECK(t60Seconds(fork, 0) < 0.1);
    CHECK(t60Seconds(fork, 1) > 10);
    CHECK(std::abs(cents(hertz(fork, 1), 440)) < 10);
    auto finer = analyse(objectMesh(fork), {.name = "fork",
                                            .source = "a test",
                                            .material = fork.material,
                                            .method = AnalysisMethod::tetrahedra,
                                            .maxFrequencyHz = 600,
                                            .elementBudget = 16000,
                                            .support = {.clamps = {*parseClamp("z<-0.0095")}},
                                            .listeningDirections = {}});
    REQUIRE(finer);
    CHECK_THAT(hertz(fork, 1), WithinRel(hertz(*finer, 1), 0.01));
}

TEST_CASE("A toy piano's rod has the partials of a cantilever, each as a pair") {
    const auto rod = stored("toy-piano-rod");
    for (const std::size_t pair : {0, 1, 2})
        CHECK_THAT(hertz(rod, 2 * pair + 1), WithinRel(hertz(rod, 2 * pair), 1e-3));
    CHECK_THAT(hertz(rod, 2) / hertz(rod, 0), WithinRel(6.267, 0.01));
    CHECK_THAT(hertz(rod, 4) / hertz(rod, 0), WithinRel(17.55, 0.02)); // short: shear lowers it
}

TEST_CASE("The lowest mode of the wind chime has its pitch, and the second is a free tube's") {
    const auto chime = stored("wind-chime");
    CHECK_THAT(cents(chime.dampedFrequencyHz(0), noteFrequencyHz(84)), WithinAbs(0, 0.2));
    CHECK_THAT(hertz(chime, 2) / hertz(chime, 0), WithinRel(2.7565, 0.06)); // shear lowers it
}
