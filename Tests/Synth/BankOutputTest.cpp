#include "ResonatorParts.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

TEST_CASE("The damper multiplies a cell by its decay, and its logarithm follows changes") {
    ResonatorParts parts(ringingObject({440}, 0.1));
    parts.output.setDamping(50, 10);
    parts.output.setDamping(0, 30);
    const double log = 50 * 20 * parts.output.cellSeconds();
    CHECK(std::abs(parts.output.dampingLog(30) - log) < 1e-12);
    CHECK(std::abs(parts.output.dampingLog(99) - log) < 1e-12);
    parts.output.setDamping(50, 99);
    CellSound sound;
    sound[0].fill(1);
    parts.output.fadeByDamper(outputsOf(sound), cellSamples);
    CHECK(std::abs(double(sound[0][63]) - std::exp(-50 * 63 / parts.sampleRateHz)) < 1e-6);
}

TEST_CASE("Discs remove the tube's part from the cell") {
    ResonatorParts parts(ringingObject({440, 880}, 0.1));
    BankOutput output(parts.bank, {0.25f, 0}, parts.sampleRateHz, parts.scratch);
    output.findTubeParts(parts.groups.starts());
    CHECK(!output.tubesPulse());
    parts.scratch.tubes = {.start = 0, .end = 0};
    CHECK(output.tubesPulse());
    const std::vector<ModeRun> runs{{0, 2}};
    REQUIRE(output.tubePartsOf(runs).size() == 1);
    CHECK(output.tubePartsOf(runs)[0].share == 0.25f);
    parts.bank.setState(0, {1, 0});
    std::array<float, cellSamples> cell{};
    output.render(parts.bank.allBlocks(), runs, cell);
    CHECK(std::abs(cell[0] - 0.75f) < 1e-6f);
}
