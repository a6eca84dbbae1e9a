#include "Instrument/Preset.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace idiophone;
using Catch::Matchers::ContainsSubstring;

namespace {

Preset example() {
    Preset preset;
    preset.name = "Bowl \"ü\"";
    preset.author = "Somebody";
    preset.description = "Rings.";
    preset.tags = {"glass", "bowl"};
    preset.keyMap = {.kind = KeyMapKind::scaled,
                     .lowestNote = 40,
                     .highestNote = 80,
                     .object = "/a/bowl.modal",
                     .strikePath = {{-1, 0.1, 0}, {0.25, 1, -1}},
                     .strikeAt = 0.3,
                     .strikeWidth = 0.5,
                     .referenceNote = 60.5};
    preset.parameters.set(ParameterId::tau, 0.123456789012345);
    preset.surface = {.name = "Slate \"ü\"",
                      .spectrumExponent = -1.1,
                      .resonFrequencyHz = 812.5,
                      .resonDampingPerSecond = 300,
                      .referenceSpeedMetresPerSecond = 0.7,
                      .slowestSpeedMetresPerSecond = 0.05,
                      .roughness = 0.3};
    preset.seed = 4294967295;
    preset.mutedModes.set("/a/bowl.modal", 3, true);
    preset.mutedModes.set("/a/bowl.modal", 0, true);
    preset.mutedModes.set("ü", ModeSet::mostModes - 1, true);
    return preset;
}

void checkRefused(const std::string& json, const char* sentence) {
    INFO(json);
    const auto preset = parsePreset(json, "x.json");
    REQUIRE_FALSE(preset);
    CHECK_THAT(preset.error().message, ContainsSubstring("x.json"));
    CHECK_THAT(preset.error().message, ContainsSubstring(sentence));
}

const std::string head = R"({"format":"idiophone-preset","version":1,"name":"A",)";
const std::string map =
    R"("keyMap":{"kind":"zones","lowestNote":0,"highestNote":9,"object":"plate"})";

} // namespace

TEST_CASE("A preset written and read back is the same preset") {
    const auto preset = example();
    const auto back = parsePreset(encodePreset(preset), "bowl.json");
    REQUIRE(back);
    CHECK(*back == preset);
    CHECK(encodePreset(*back) == encodePreset(preset));
}

TEST_CASE("Parameters may be given as they are shown, and unknown ones are remembered") {
    const auto preset = parsePreset(
        head + map + R"(,"parameters":{"material":"Glass","young":"70 GPa","x9":1}})", "x.json");
    REQUIRE(preset);
    CHECK(preset->parameters[ParameterId::youngsModulus] == 70);
    CHECK(preset->parameters[ParameterId::material] > static_cast<double>(customMaterial));
    CHECK(preset->unknownParameters == std::vector<std::string>{"x9"});
    CHECK(preset->parameters[ParameterId::tau] == parameterInfo(ParameterId::tau).defaultValue);
}

TEST_CASE("A preset that makes no sense is refused with its fault") {
    checkRefused("", "not JSON");
    checkRefused("[]", "not an Idiophone preset");
    checkRefused(R"({"format":"idiophone-preset","version":2,"name":"A"})", "newer Idiophone");
    checkRefused(R"({"format":"idiophone-preset","version":"1","name":"A"})", "'version'");
    checkRefused(R"({"format":"idiophone-preset","version":1,"name":"",)" + map + "}", "name");
    checkRefused(R"({"format":"idiophone-preset","version":1,"name":"A"})", "'keyMap'");
    checkRefused(head + R"("keyMap":{"kind":"rows"}})", "'rows'");
    checkRefused(head + R"("keyMap":{"kind":"bars","lowestNote":9,"highestNote":3,"object":"x"}})",
                 "'highestNote'");
    checkRefused(head +
                     R"("keyMap":{"kind":"bars","lowestNote":60.7,"highestNote":70,"object":"x"}})",
                 "'lowestNote' is not a whole number");
    checkRefused(head +
                     R"("keyMap":{"kind":"bars","lowestNote":60,"highestNote":70.2,"object":"x"}})",
                 "'highestNote' is not a whole number");
    checkRefused(R"({"format":"idiophone-preset","version":1.5,"name":"A",)" + map + "}",
                 "'version' is not a whole number");
    checkRefused(head + map.substr(0, map.size() - 1) + R"(,"strikePath":[]}})", "'strikePath'");
    checkRefused(head + map.substr(0, map.size() - 1) + R"(,"strikePath":[[0,0,9]]}})", "between");
    checkRefused(head + map + R"(,"parameters":{"tau":"loud"}})", "'tau'");
    checkRefused(head + map + R"(,"tags":[1]})", "'tags'");
    checkRefused(head + map + R"(,"surface":3})", "its surface");
    checkRefused(head + map + R"(,"surface":{"format":"idiophone-surface","version":1}})", "lacks");
    checkRefused(head + map + R"(,"seed":1.5})", "'seed'");
    checkRefused(head + map + R"(,"seed":-1})", "'seed'");
    checkRefused(head + map + R"(,"seed":4294967296})", "'seed'");
    const auto refuseMuted = [](const std::string& muted, const char* sentence) {
        checkRefused(head + map + R"(,"mutedModes":)" + muted + "}", sentence);
    };
    refuseMuted("[1]", "'mutedModes'");
    refuseMuted(R"({"plate":3})", "'plate'");
    for (const auto* mode :
         {"-1", "1.5", "\"x\"", "1048576", "1e300", "18446744073709551615", "null"})
        refuseMuted(R"({"plate":[0,)" + std::string(mode) + "]}", "the number of a mode");
    std::string many = "0";
    for (int mode = 1; mode <= 16384; ++mode)
        many += "," + std::to_string(mode);
    refuseMuted(R"({"plate":[)" + many + "]}", "more than 16384");
    checkRefused(std::string(2 << 20, ' '), "too large");
}

TEST_CASE("A surface nested half a million deep is refused, and does not exhaust the stack") {
    const auto deep = std::string(500000, '[') + std::string(500000, ']');
    checkRefused(head + map + R"(,"surface":)" + deep + "}", "not JSON");
}

TEST_CASE("What a preset says is fit for one line in the sentence that refuses it") {
    checkRefused(head + R"("keyMap":{"kind":"two\nlines"}})", "'two?lines'");
    checkRefused(head + map + R"(,"mutedModes":{"two\nlines":7}})", "'two?lines'");
    checkRefused(head + map + R"(,"mutedModes":{"two\nlines":[-1]}})", "'two?lines'");
}
