#include "Instrument/ImpulseLine.h"
#include "Support/SyntheticObject.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <nlohmann/json.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

TEST_CASE("A blow is one line of JSON that says when, what, where and how") {
    const SynthesiserSlot slot{.object =
                                   std::make_shared<const ModalObject>(syntheticObject({100}))};
    const PlacedBlow blow{
        .seconds = 1.25,
        .slot = 3,
        .strike = {.point = {}, .impulseNewtonSeconds = {0, 0.5f, -2}, .durationSeconds = 0.002},
        .pointMetres = {0.1, 0.2, -0.3}};
    const auto text = impulseLine(slot, blow);
    CHECK(text.find('\n') == text.size() - 1);
    const auto line = nlohmann::json::parse(text);
    CHECK(line["time"] == 1.25);
    CHECK(line["object"] == "synthetic");
    CHECK(line["body"] == 3);
    CHECK(line["point"] == nlohmann::json({0.1, 0.2, -0.3}));
    CHECK(line["impulse"] == nlohmann::json({0, 0.5, -2}));
    CHECK(line["contact_time"] == 0.002);
    CHECK_FALSE(line.contains("size"));

    const SynthesiserSlot large{.object = slot.object, .sizeRatio = 2};
    CHECK(nlohmann::json::parse(impulseLine(large, blow))["size"] == 2);
}
