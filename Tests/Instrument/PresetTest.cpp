#include "Instrument/Preset.h"
#include "Instrument/JsonPlace.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

using namespace idiophone;
using Catch::Matchers::WithinAbs;

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
                     .resizedFrom = 30,
                     .resizedTo = 90,
                     .object = "/a/bowl.modal",
                     .strikePath = {{-1, 0.1, 0}, {0.25, 1, -1}},
                     .strikeAt = {0.3, 0.6, 0.5},
                     .strikeWidth = 0.5,
                     .referenceNote = 60.5};
    preset.parameters.set(ParameterId::tau, 0.123456789012345);
    preset.matchedTo = preset.parameters;
    preset.matchedTo->set(ParameterId::density, 7800.5);
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
    preset.mutedModes.set("ü", ModeSet::maximumModes - 1, true);
    return preset;
}

void checkRefused(const std::string& json, const std::string& sentence) {
    INFO(json.substr(0, 1000));
    const auto preset = parsePreset(json, "x.json");
    REQUIRE_FALSE(preset);
    CHECK(preset.error().message == "x.json: " + sentence);
}

const std::string head = R"({"format":"idiophone-preset","version":1,"name":"A",)";
const std::string map =
    R"("keyMap":{"kind":"zones","lowestNote":0,"highestNote":9,"object":"plate"})";

} // namespace

TEST_CASE("A preset written and read back is equal") {
    const auto preset = example();
    const auto back = parsePreset(encodePreset(preset), "bowl.json");
    REQUIRE(back);
    CHECK(*back == preset);
    CHECK(encodePreset(*back) == encodePreset(preset));
}

TEST_CASE("A kit written and read back is equal") {
    Preset preset = example();
    preset.keyMap = kitOf(
        {{.keyMap = example().keyMap,
          .lowestVelocity = 10,
          .highestVelocity = 90,
          .material = firstLibraryMaterial,
          .mallet = firstRackMallet,
          .levelDb = -3.5,
          .chokeGroup = 2,
          .output = 5},
         {.keyMap = {
              .kind = KeyMapKind::zones, .lowestNote = 36, .highestNote = 36, .object = "plate"}}});
    const auto back = parsePreset(encodePreset(preset), "kit.json");
    REQUIRE(back);
    CHECK(*back == preset);
    CHECK(back->keyMap.lowestNote == 36);
    CHECK(back->keyMap.highestNote == 80);
    CHECK(objectNames(back->keyMap) == std::vector<std::string>{"/a/bowl.modal", "plate"});
}

TEST_CASE("A kit with a fault is refused by a sentence that names its place") {
    const auto refuse = [](const std::string& parts, const std::string& sentence) {
        checkRefused(head + R"("keyMap":{"kind":"kit","parts":)" + parts + "}}", sentence);
    };
    const std::string part =
        R"({"keyMap":{"kind":"zones","lowestNote":60,"highestNote":61,"object":"plate"})";
    refuse("[]", "keyMap.parts are not 1 to 128");
    refuse("[" + part + "}," + part + "}," + part + "}]",
           "keyMap.parts are more than 2 on key 60 at velocity 1");
    refuse("[" + part + R"(,"highestVelocity":0}])",
           "keyMap.parts[0].highestVelocity is not between 1 and 127");
    refuse("[" + part + R"(,"material":"Cheese"}])",
           "keyMap.parts[0].material is 'Cheese', which is no choice of 'Material'");
    refuse("[" + part + R"(,"material":"Custom"}])",
           "keyMap.parts[0].material is 'Custom', but the custom figures belong to all parts");
    refuse("[" + part + R"(,"output":9}])", "keyMap.parts[0].output is not between 1 and 8");
    refuse(R"([{"keyMap":{"kind":"kit","parts":[)" + part + "}]}}]",
           "keyMap.parts have a scene or a kit among them");
}

TEST_CASE("Parameters are read as displayed text, and unknown parameters are kept") {
    const auto preset = parsePreset(
        head + map + R"(,"parameters":{"material":"Glass","young":"70 GPa","x9":1}})", "x.json");
    REQUIRE(preset);
    CHECK(preset->parameters[ParameterId::youngsModulus] == 70);
    CHECK(preset->parameters[ParameterId::material] > static_cast<double>(customMaterial));
    CHECK(preset->unknownParameters == std::vector<std::string>{"x9"});
    CHECK(preset->parameters[ParameterId::tau] == parameterInfo(ParameterId::tau).defaultValue);
}

TEST_CASE("Loudness is matched to the preset itself, or to the values that the file gives") {
    const auto values = R"("parameters":{"density":"2500 kg/m³","tau":5})";
    const auto plain = parsePreset(head + map + "," + values + "}", "x.json");
    REQUIRE(plain);
    CHECK(plain->matched() == plain->parameters);
    const auto other = parsePreset(
        head + map + "," + values + R"(,"matchedTo":{"density":7800,"sheen":1}})", "x.json");
    REQUIRE(other);
    CHECK(other->parameters == plain->parameters);
    auto expected = plain->parameters;
    expected.set(ParameterId::density, 7800);
    CHECK(other->matched() == expected);
    checkRefused(head + map + R"(,"matchedTo":{"density":[]}})",
                 "matchedTo.density is a value that it cannot take");
}

TEST_CASE("An invalid preset is refused with its fault and the fault's place") {
    checkRefused("", "it is not JSON (line 1, column 1)");
    checkRefused("{\n  \"name\": }", "it is not JSON (line 2, column 11)");
    checkRefused("[]", "it is not an Idiophone preset");
    checkRefused(R"({"format":"idiophone-preset","version":2,"name":"A"})",
                 "it was made by a newer Idiophone (preset version 2)");
    checkRefused(R"({"format":"idiophone-preset","version":"1","name":"A"})",
                 "version is not a whole number");
    checkRefused(R"({"format":"idiophone-preset","version":1.5,"name":"A",)" + map + "}",
                 "version is not a whole number");
    checkRefused(R"({"format":"idiophone-preset","version":1,"name":"",)" + map + "}",
                 "name is empty");
    checkRefused(R"({"format":"idiophone-preset","version":1,"name":"A"})", "it lacks 'keyMap'");
    checkRefused(head + map + R"(,"tags":[1]})", "tags[0] is not a text");
    checkRefused(head + map + R"(,"tags":"bell"})", "tags is not a list");
    std::string tags = R"("b")";
    for (std::size_t tag = 1; tag < maximumTags; ++tag)
        tags += R"(,"b")";
    CHECK(parsePreset(head + map + R"(,"tags":[)" + tags + "]}", "x.json"));
    checkRefused(head + map + R"(,"tags":[)" + tags + R"(,""]})",
                 "tags is a list of more than 1000");
    checkRefused(head + map + R"(,"parameters":[]})", "parameters is not a JSON object");
    checkRefused(head + map + R"(,"parameters":{"tau":"loud"}})",
                 "parameters.tau is a value that it cannot take");
    checkRefused(head + map + R"(,"parameters":{"mod3_target":"Wobble"}})",
                 "parameters.mod3_target is a value that it cannot take");
    checkRefused(head + map + R"(,"surface":3})", "surface is not an Idiophone surface");
    checkRefused(head + map + R"(,"surface":{"format":"idiophone-surface","version":1}})",
                 "surface lacks 'spectrum_exponent'");
    checkRefused(head + map + R"(,"seed":1.5})", "seed is not a whole number");
    for (const char* seed : {"-1", "4294967296"})
        checkRefused(head + map + R"(,"seed":)" + seed + "}",
                     "seed is not between 0 and 4294967295");
    checkRefused(std::string(2 << 20, ' '), "it is too large for a preset");
}

TEST_CASE("An invalid key map is refused with its fault and the fault's place") {
    const auto refuse = [](const std::string& keyMap, const std::string& sentence) {
        checkRefused(head + R"("keyMap":)" + keyMap + "}", sentence);
    };
    const std::string open = map.substr(map.find('{'), map.size() - map.find('{') - 1);
    refuse("3", "keyMap lacks 'kind'");
    refuse(R"({"kind":"rows"})",
           "keyMap.kind is 'rows' and none of bars, zones, scaled, scene and kit");
    refuse(R"({"kind":"bars","lowestNote":9,"highestNote":3,"object":"x"})",
           "keyMap.highestNote is not between 9 and 127");
    refuse(R"({"kind":"bars","lowestNote":60.7,"highestNote":70,"object":"x"})",
           "keyMap.lowestNote is not a whole number");
    refuse(R"({"kind":"bars","lowestNote":60,"highestNote":70.2,"object":"x"})",
           "keyMap.highestNote is not a whole number");
    refuse(R"({"kind":"bars","lowestNote":60,"highestNote":70})", "keyMap lacks 'object'");
    refuse(R"({"kind":"scene","lowestNote":0,"highestNote":9,"object":")" +
               std::string(JsonPlace::longestTextBytes + 1, '/') + "\"}",
           "keyMap.object is longer than 4096 bytes");
    refuse(open + R"(,"strikePath":[]})", "keyMap.strikePath has no points");
    refuse(open + R"(,"strikePath":[[0,0,0],[0,9,0]]})",
           "keyMap.strikePath[1][1] is not between -1 and 1");
    refuse(open + R"(,"strikePath":[[0,0]]})",
           "keyMap.strikePath[0] is not a list of three numbers [x, y, z]");
    refuse(open + R"(,"strikeAt":"low"})", "keyMap.strikeAt is not a number");
    refuse(open + R"(,"strikeAt":[0,1.1]})", "keyMap.strikeAt[1] is not between 0 and 1");
    refuse(open + R"(,"strikeAt":[]})", "keyMap.strikeAt is empty");
}

TEST_CASE("Keys strike at interpolated places of the key map") {
    KeyMap keys{.kind = KeyMapKind::bars, .lowestNote = 40, .highestNote = 50, .object = "bar"};
    CHECK(keys.strikePlace(47) == 0.5);
    keys.strikeAt = {0.2, 0.4, 0.3};
    CHECK(keys.strikePlace(40) == 0.2);
    CHECK_THAT(keys.strikePlace(44), WithinAbs(0.36, 1e-12));
    CHECK_THAT(keys.strikePlace(48), WithinAbs(0.34, 1e-12));
    CHECK(keys.strikePlace(50) == 0.3);
    keys.kind = KeyMapKind::zones;
    CHECK_THAT(keys.strikePlace(42), WithinAbs(0.2, 1e-12));
    keys.highestNote = 40;
    CHECK(keys.strikePlace(40) == 0.2);
}

TEST_CASE("Invalid muted modes are refused with their fault and the fault's place") {
    const auto refuse = [](const std::string& muted, const std::string& sentence) {
        checkRefused(head + map + R"(,"mutedModes":)" + muted + "}", sentence);
    };
    refuse("[1]", "mutedModes is not a JSON object");
    refuse(R"({"plate":3})", "mutedModes.plate is not a list");
    for (const auto* mode : {"1.5", "\"x\"", "null"})
        refuse(R"({"plate":[0,)" + std::string(mode) + "]}",
               "mutedModes.plate[1] is not a whole number");
    for (const auto* mode : {"-1", "1048576", "1e300", "18446744073709551615"})
        refuse(R"({"plate":[0,)" + std::string(mode) + "]}",
               "mutedModes.plate[1] is not between 0 and 1048575");
    std::string many = "0";
    for (int mode = 1; mode < 16384; ++mode)
        many += "," + std::to_string(mode);
    CHECK(parsePreset(head + map + R"(,"mutedModes":{"plate":[)" + many + "]}}", "x.json"));
    refuse(R"({"plate":[)" + many + R"(],"ring":[0]})", "mutedModes are more than 16384");
    refuse(R"({"plate":[)" + many + ",0]}", "mutedModes.plate is a list of more than 16384");
}

TEST_CASE("A surface nested half a million deep is refused without exhausting the stack") {
    const auto deep = std::string(500000, '[') + std::string(500000, ']');
    checkRefused(head + map + R"(,"surface":)" + deep + "}", "it is not JSON");
}

TEST_CASE("Text of a preset fits on one line in the error that quotes it") {
    checkRefused(head + R"("keyMap":{"kind":"two\nlines"}})",
                 "keyMap.kind is 'two?lines' and none of bars, zones, scaled, scene and kit");
    checkRefused(head + map + R"(,"mutedModes":{"two\nlines":7}})",
                 "mutedModes.two?lines is not a list");
}

TEST_CASE("Long texts of a preset are cut between characters") {
    const auto quoted = [](const std::string& text) { return "\"" + text + "\""; };
    const std::string odd = "x"; // so that no limit falls between two characters
    std::string long500 = odd, long4000 = odd;
    while (long500.size() < longestNameBytes - 1)
        long500 += "ü";
    while (long4000.size() < longestDescriptionBytes - 1)
        long4000 += "ü";
    const auto endless = odd + [] {
        std::string text;
        for (int k = 0; k < 20'000; ++k)
            text += "ü";
        return text;
    }();
    std::string tags = quoted(endless);
    for (int k = 1; k < 20; ++k)
        tags += "," + quoted(endless);
    const auto preset = parsePreset(R"({"format":"idiophone-preset","version":1,"name":)" +
                                        quoted(endless) + R"(,"author":)" + quoted(endless) +
                                        R"(,"description":)" + quoted(endless) + "," + map + "}",
                                    "x.json");
    REQUIRE(preset);
    CHECK(preset->name == long500);
    CHECK(preset->author == long500);
    CHECK(preset->description == long4000);
    const auto tagged = parseSavedPreset(head + map + R"(,"tags":[)" + tags + "]}", "x.json");
    REQUIRE(tagged);
    CHECK(tagged->tags == std::vector<std::string>(8, long500));
    CHECK(parsePreset(encodePreset(*tagged), "x.json") == *tagged);
}
