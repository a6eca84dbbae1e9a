#include "Analysis/RecordedMaterial.h"

#include "Geometry/ParametricMesh.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <numbers>
#include <vector>

using namespace idiophone;
using Catch::Matchers::ContainsSubstring;

namespace {

/// A strike with a loss factor of 0.002, whose pitches are those of no plate.
std::vector<float> strike() {
    constexpr int rate = 48000;
    std::vector<float> samples(rate / 5);
    for (int i = 0; i < rate; ++i) {
        double sample = 0;
        for (const double hz : {500.0, 1000.0, 1500.0, 2000.0, 2500.0, 3000.0})
            sample += 0.1 * std::exp(-0.001 * 2 * std::numbers::pi * hz * i / rate) *
                      std::sin(2 * std::numbers::pi * hz * i / rate);
        samples.push_back(static_cast<float>(sample));
    }
    return samples;
}

} // namespace

TEST_CASE("A material of a recording has its name, its source, and words on what was found") {
    const auto samples = strike();
    const auto made = materialOfRecording(
        {.name = "folder/strike.wav", .samples = samples, .sampleRateHz = 48000}, "Chime",
        std::nullopt);
    REQUIRE(made);
    const auto& material = made->fit.material;
    CHECK(material.name == "Chime");
    CHECK_THAT(material.source, ContainsSubstring("damping fitted to strike.wav"));
    CHECK(std::abs(decaySeconds(material, 1000) / (std::log(1000) / (2 * std::numbers::pi)) - 1) <
          0.2);
    CHECK_THAT(made->findings, ContainsSubstring("like " + made->fit.resembles) &&
                                   ContainsSubstring(" s at 1000 Hz"));
    CHECK_THAT(made->notes, ContainsSubstring("only the damping is fitted") &&
                                ContainsSubstring("are those of " + made->fit.resembles));
}

TEST_CASE("An error of a material names the recording or the struck object") {
    const auto samples = strike();
    const StrikeRecording recording{
        .name = "strike.wav", .samples = samples, .sampleRateHz = 48000};
    const auto faultOf = [&](const StruckObject& object) {
        const auto made = materialOfRecording(recording, "Chime", object);
        return made ? std::string() : made.error().message;
    };
    CHECK_THAT(
        faultOf(
            {.name = "plate.obj", .mesh = sheetMesh(0.06, 0.036, 150), .thicknessMetres = 0.002}),
        ContainsSubstring("strike.wav: its modes are not those of plate.obj"));
    CHECK_THAT(faultOf({.name = "open.obj",
                        .mesh = sheetMesh(0.06, 0.036, 150),
                        .method = AnalysisMethod::tetrahedra}),
               ContainsSubstring("open.obj: ") && ContainsSubstring("its surface is open"));
    const std::vector<float> silence(48000);
    const auto none = materialOfRecording(
        {.name = "silence.wav", .samples = silence, .sampleRateHz = 48000}, "Chime", std::nullopt);
    REQUIRE_FALSE(none);
    CHECK_THAT(none.error().message, ContainsSubstring("silence.wav"));
}
