#include "Analysis/TubeTuning.h"

#include "Analysis/BarTuning.h"
#include "Analysis/FactoryBars.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

using namespace idiophone;
using Catch::Matchers::WithinRel;

namespace {

TubeSpecification brassTube(double noteHz) {
    return {.name = "tube",
            .source = "test",
            .noteFrequencyHz = noteHz,
            .material = *findMaterial("Brass"),
            .maxFrequencyHz = 4000};
}

} // namespace

TEST_CASE("A long thin tube has Euler's and Bernoulli's bending ratios within 2 %", "[.weekly]") {
    auto tube = brassTube(noteFrequencyHz(48));
    tube.outerDiameterMetres = 0.020;
    tube.maxFrequencyHz = 1500;
    const auto tuned = tuneTube(tube);
    REQUIRE(tuned);
    const double ratios[] = {1, 2.756539, 5.403918, 8.932950};
    for (std::size_t mode = 1; mode < std::size(ratios); ++mode)
        CHECK_THAT(tuned->bendingHz[mode] / tuned->bendingHz[0], WithinRel(ratios[mode], 0.02));
    CHECK_THAT(tuned->lengthMetres,
               WithinRel(slenderTubeLengthMetres(tube, 2 * tube.noteFrequencyHz), 0.03));
}

TEST_CASE("A tubular bell's mode 4 is an octave above its note, with 5 and 6 near 2 : 3 : 4",
          "[.weekly]") {
    constexpr int note = 77;
    const auto tuned = tuneTube(brassTube(noteFrequencyHz(note)));
    REQUIRE(tuned);
    const auto& hz = tuned->bendingHz;
    CHECK(std::abs(cents(hz[3], 2 * noteFrequencyHz(note))) < 0.2);
    CHECK_THAT(hz[4] / hz[3], WithinRel(1.5, 0.05));
    CHECK_THAT(hz[5] / hz[3], WithinRel(2.0, 0.06));
    CHECK((tuned->lengthMetres > 0.9 && tuned->lengthMetres < 1.7));
    CHECK(tuned->object.provenance.zeroModes == 6);
    CHECK(tuned->object.shapeVertexCount() == 44);
    // The object must store the tuned modes.
    double closest = 1e9;
    for (const double eigenvalue : tuned->object.eigenvalues)
        closest = std::min(
            closest, std::abs(cents(dampedFrequencyHz(eigenvalue, tuned->object.material), hz[3])));
    CHECK(closest < 0.1);
}

TEST_CASE("A tube that cannot be built gives a one-sentence error") {
    auto thick = brassTube(262);
    thick.wallMetres = 0.03;
    CHECK_FALSE(tuneTube(thick));
    auto second = brassTube(262);
    second.tunedMode = 2;
    CHECK_FALSE(tuneTube(second));
    auto narrowBand = brassTube(262);
    narrowBand.maxFrequencyHz = 1000;
    const auto refused = tuneTube(narrowBand);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message.find("tube") != std::string::npos);
}
