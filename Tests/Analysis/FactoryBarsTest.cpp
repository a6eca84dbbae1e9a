#include "Analysis/FactoryBars.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

using namespace idiophone;

TEST_CASE("Notes are equal-tempered about A4 = 440 Hz") {
    CHECK(noteFrequencyHz(69) == 440);
    CHECK_THAT(noteFrequencyHz(60), Catch::Matchers::WithinRel(261.6255653, 1e-9));
}

TEST_CASE("The xylophone's bars have a real bar's measures, and lengths that fall note by note") {
    double previous = 1;
    for (int note = lowestXylophoneNote; note <= highestXylophoneNote; ++note) {
        const auto bar = rosewoodXylophoneBar(note);
        const double length = estimatedBarLengthMetres(bar);
        CHECK(length < previous);
        CHECK((length > 0.140 && length < 0.390));
        CHECK((bar.widthMetres >= 0.030 && bar.widthMetres <= 0.040));
        CHECK((bar.heightMetres >= 0.015 && bar.heightMetres <= 0.024));
        previous = length;
    }
}

TEST_CASE("The lowest, middle and highest xylophone bars are in tune and bend first") {
    for (const int note : {72, 90, 108}) {
        const auto bar = tuneBar(rosewoodXylophoneBar(note));
        REQUIRE(bar);
        CHECK(std::abs(cents(bar->fundamentalHz, noteFrequencyHz(note))) < 0.05);
        CHECK(bar->bendingMode == 0);
        CHECK((bar->lengthMetres > 0.140 && bar->lengthMetres < 0.390));
        CHECK((bar->mesh.vertexCount() > 800 && bar->mesh.vertexCount() < 1250));
        CHECK((bar->object.shapeVertexCount() > 240 && bar->object.shapeVertexCount() < 310));
        CHECK(bar->object.provenance.zeroModes == 6);
        CHECK(bar->object.modeCount() > 10);
    }
}
