#include "Instrument/SurfaceFile.h"

#include "Instrument/JsonPlace.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <nlohmann/json.hpp>

using namespace idiophone;
using Catch::Matchers::ContainsSubstring;

namespace {

const Surface slate{.name = "Slate \"ü\"",
                    .spectrumExponent = -1.31415926535897,
                    .resonFrequencyHz = 812.3,
                    .resonDampingPerSecond = 440.1,
                    .referenceSpeedMetresPerSecond = 0.3,
                    .slowestSpeedMetresPerSecond = 0.01,
                    .roughness = 0.25};

Result<Surface> parsed(const std::string& text) {
    return parsedJson(text, "x.json", surfaceAt);
}

void checkRefused(const std::string& text, const char* sentence) {
    INFO(text);
    const auto surface = parsed(text);
    REQUIRE_FALSE(surface);
    CHECK_THAT(surface.error().message, ContainsSubstring("x.json: "));
    CHECK_THAT(surface.error().message, ContainsSubstring(sentence));
}

std::string slateWith(const char* key, const nlohmann::json& value) {
    auto root = nlohmann::json::parse(encodeSurface(slate));
    root[key] = value;
    return root.dump();
}

std::string slateWithout(const char* key) {
    auto root = nlohmann::json::parse(encodeSurface(slate));
    root.erase(key);
    return root.dump();
}

} // namespace

TEST_CASE("A surface survives its file to the last bit") {
    const auto read = parsed(encodeSurface(slate));
    REQUIRE(read);
    CHECK(*read == slate);
}

TEST_CASE("A surface with the longest name is read back, and a longer name is refused") {
    auto longest = slate;
    longest.name = std::string(Surface::longestNameBytes, '\x01'); // six bytes each in the file
    const auto read = parsed(encodeSurface(longest));
    REQUIRE(read);
    CHECK(*read == longest);
    checkRefused(slateWith("name", std::string(65000, 'x')), "name is longer than");
}

TEST_CASE("Name, slowest speed and roughness are optional in a surface file") {
    CHECK(parsed(slateWithout("name"))->name.empty());
    CHECK(parsed(slateWithout("roughness"))->roughness == Surface{}.roughness);
    CHECK(parsed(slateWithout("slowest_speed_m_per_s"))->slowestSpeedMetresPerSecond == 0.1 * 0.3);
}

TEST_CASE("A bad surface file is refused with one sentence that names the file and the fault") {
    checkRefused("", "not JSON");
    checkRefused("{", "not JSON");
    checkRefused("[]", "not an Idiophone surface");
    checkRefused(R"({"format":"idiophone-preset"})", "not an Idiophone surface");
    checkRefused(R"({"format":7,"version":1})", "not an Idiophone surface");
    checkRefused(slateWith("version", 2), "newer");
    checkRefused(slateWith("version", "1"), "version");
    checkRefused(slateWith("version", 0), "version");
    checkRefused(slateWith("name", 3), "name is not a text");
    checkRefused(slateWith("roughness", "much"), "roughness is not a number");
    checkRefused(slateWith("reson_frequency_hz", nullptr), "reson_frequency_hz is not a number");
    checkRefused(slateWith("colour", 1), "no 'colour'");
    checkRefused(slateWithout("spectrum_exponent"), "lacks 'spectrum_exponent'");
    checkRefused(slateWithout("reson_damping_per_s"), "lacks 'reson_damping_per_s'");
    checkRefused(slateWith("spectrum_exponent", -40), "exponent");
    checkRefused(slateWith("reference_speed_m_per_s", 0), "speed");
    checkRefused(std::string(60000, '['), "not JSON");
}

TEST_CASE("Text of a surface file fits on one line in the error that quotes it") {
    checkRefused(slateWith("two\nlines", 1), "no 'two?lines'");
}
