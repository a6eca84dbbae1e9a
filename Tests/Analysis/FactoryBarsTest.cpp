#include "Analysis/FactoryBars.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

using namespace idiophone;

TEST_CASE("Notes are equal-tempered with A4 = 440 Hz") {
    CHECK(noteFrequencyHz(69) == 440);
    CHECK_THAT(noteFrequencyHz(60), Catch::Matchers::WithinRel(261.6255653, 1e-9));
}

TEST_CASE("Every bar of every instrument has a tunable arch and its own name") {
    for (const auto& instrument : barInstruments()) {
        CHECK(findBarInstrument(instrument.name) == &instrument);
        for (int note = instrument.lowestNote; note <= instrument.highestNote; ++note) {
            auto bar = instrument.barAt(note, noteFrequencyHz(note));
            CHECK(bar.name == instrument.barName(note));
            INFO(bar.name);
            if (bar.held) { // has no arch, and its length is tuned by finite elements
                CHECK(bar.targets.count() == 1);
                CHECK(bar.shape.centreHeightMetres == bar.shape.heightMetres);
                continue;
            }
            bar.shape.lengthMetres = 0.2;
            const auto arch = tunedArch(bar.shape, beamMaterial(bar.material), bar.targets);
            REQUIRE(arch);
            CHECK((arch->lengthMetres > 0.06 && arch->lengthMetres < 0.5));
            CHECK(arch->centreHeightMetres >= 0.0025);
        }
    }
    CHECK(findBarInstrument("kazoo") == nullptr);
}
