#include "Plugin/State.h"

#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <random>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::StartsWith;

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto place = text.find(from);
    REQUIRE(place != std::string::npos);
    return text.replace(place, from.size(), to);
}

void checkRefused(const std::string& bytes) {
    const auto state = parseState(bytes);
    INFO(bytes.substr(0, 200));
    REQUIRE_FALSE(state);
    CHECK_THAT(state.error().message, StartsWith("The saved state "));
    CHECK(state.error().message.back() == '.');
    CHECK(state.error().message.find('\n') == std::string::npos);
}

State randomState(unsigned seed) {
    std::mt19937 random(seed);
    auto state = testState();
    for (const auto& info : parameterTable())
        state.parameters.set(
            info.parameter,
            info.fromNormalised(std::uniform_real_distribution<double>(0, 1)(random)));
    state.preset.surface.roughness = std::uniform_real_distribution<double>(0, 100)(random);
    state.preset.seed = random();
    if (seed % 4 == 0)
        state.origin = {.presetId = "Mine/Bell.json",
                        .presetContent = 0x8000'0000'0000'0000U + seed,
                        .stored = state.parameters};
    if (seed % 2 == 0)
        state.tuning.scale = {.name = "a.scl", .text = "line\n\"quoted\"\t\xc3\xa9\n"};
    if (seed % 3 == 0)
        state.tuning.mapping = {.name = "a.kbm", .text = "0\r\n127"};
    return state;
}

} // namespace

TEST_CASE("A state reads back equal to the last bit and writes the same bytes again") {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const auto state = randomState(seed);
        const auto bytes = encodeState(state);
        const auto read = parseState(bytes);
        REQUIRE(read);
        CHECK(*read == state);
        CHECK(encodeState(*read) == bytes);
    }
}

TEST_CASE("Embedded objects are restored byte for byte, whatever they contain") {
    State state = testState();
    state.objects = {{.name = "empty bytes", .modal = {std::byte{0}}}};
    std::mt19937 random(3);
    std::vector<std::byte> noise(300000);
    for (auto& value : noise)
        value = static_cast<std::byte>(random());
    state.objects.push_back({.name = "noise", .modal = noise});
    state.objects.push_back({.name = "zeros", .modal = std::vector<std::byte>(1000000)});
    const auto bytes = encodeState(state);
    CHECK(bytes.size() < 500000);
    const auto read = parseState(bytes);
    REQUIRE(read);
    CHECK(read->objects == state.objects);
}

TEST_CASE("An object whose packed text is known is written as that text") {
    State state = testState();
    state.objects.resize(1);
    auto& object = state.objects.front();
    object.packed = std::make_shared<const std::string>(packedModal(object.modal));
    const auto bytes = encodeState(state);
    object.modal.clear();
    CHECK(encodeState(state) == bytes);
    const auto read = parseState(bytes);
    REQUIRE(read);
    CHECK(*read->objects.front().packed == *object.packed);
}

TEST_CASE("Unknown members and parameters in a state are ignored") {
    const auto state = testState();
    auto bytes = encodeState(state);
    for (const auto* place :
         {"{\"format\":\"idiophone-state\",", "\"parameters\":{", "\"preset\":{", "\"keyMap\":{"})
        bytes = replaced(bytes, place, place + std::string("\"unheard\":1,"));
    const auto read = parseState(bytes);
    REQUIRE(read);
    CHECK(*read == state);
}

TEST_CASE("A preset in a state may lack a name, and its overlong texts are cut") {
    auto state = testState();
    state.objects.resize(1);
    state.preset.name.clear();
    state.preset.description = std::string(2 * largestPresetBytes, 'x');
    const auto read = parseState(encodeState(state));
    REQUIRE(read);
    state.preset.description.resize(longestDescriptionBytes);
    CHECK(*read == state);
}

TEST_CASE("A tuning file of the largest size is restored, whatever its bytes") {
    auto state = testState();
    state.tuning.scale = {.name = "a.scl",
                          .text = std::string(ScalaTuning::largestFileBytes, '\xe9')};
    const auto read = parseState(encodeState(state));
    REQUIRE(read);
    CHECK(encodeState(*read) == encodeState(state));
}

TEST_CASE(
    "A missing parameter gets its default, and one out of range gets the nearest valid value") {
    const auto bytes = encodeState(testState());
    const auto without = parseState(replaced(bytes, "\"tune\":0.0,", ""));
    REQUIRE(without);
    CHECK(without->parameters[ParameterId::tune] == 0);
    const auto outside = parseState(replaced(bytes, "\"tune\":0.0", "\"tune\":1e99"));
    REQUIRE(outside);
    CHECK(outside->parameters[ParameterId::tune] == 1200);
}

TEST_CASE("A state of a newer format is refused with one sentence") {
    const auto state =
        parseState(replaced(encodeState(testState()), "\"version\":1", "\"version\":2"));
    REQUIRE_FALSE(state);
    CHECK(state.error().message ==
          "The saved state was made by a newer Idiophone (state version 2).");
}

TEST_CASE("Damaged states are refused with one sentence each") {
    const auto good = encodeState(testState());
    checkRefused("");
    checkRefused("{}");
    checkRefused("[]");
    checkRefused("null");
    checkRefused("{\"format\":7}");
    checkRefused(std::string(100000, '['));
    const auto deep = std::string(500000, '[') + std::string(500000, ']');
    checkRefused(replaced(good, "\"preset\":{", "\"preset\":" + deep + ",\"was\":{"));
    checkRefused(replaced(good, "\"tune\":0.0", "\"two\\nlines\":null"));
    checkRefused(replaced(good, "\"version\":1", "\"version\":-1"));
    checkRefused(replaced(good, "\"version\":1", "\"version\":\"1\""));
    checkRefused(replaced(good, "\"version\":1", "\"version\":1e400"));
    checkRefused(replaced(good, "\"tune\":0.0", "\"tune\":null"));
    checkRefused(replaced(good, "\"tune\":0.0", "\"tune\":1e999"));
    checkRefused(replaced(good, "\"preset\":{", "\"preset\":3,\"was\":{"));
    checkRefused(replaced(good, "\"objects\":[", "\"objects\":3,\"were\":["));
    checkRefused(replaced(good, "\"objects\":[", "\"objects\":[7,"));
    checkRefused(replaced(good, "\"modal\":\"", "\"modal\":\"!!"));
    checkRefused(replaced(good, "\"modal\":\"", "\"modal\":\"AAAA"));
    const auto with = [&](const std::string& member) {
        auto bytes = good;
        bytes.back() = ',';
        return bytes + member + "}";
    };
    for (const auto* origin : {"7", "{}", R"({"preset":"a","content":-1,"parameters":{}})",
                               R"({"preset":7,"content":1,"parameters":{}})",
                               R"({"preset":"a","content":1,"parameters":{"tau":"x"}})"})
        checkRefused(with(std::string("\"origin\":") + origin));
    for (const auto* controllers :
         {"7", "[]", "null", R"({"tau":-1})", R"({"tau":0})", R"({"tau":120})", R"({"tau":1e9})",
          R"({"tau":7.5})", R"({"tau":"7"})", R"({"tau":99999999999999999999})"})
        checkRefused(with(std::string("\"controllers\":") + controllers));
}

TEST_CASE("Learned controllers are saved and restored") {
    auto state = testState();
    state.controllers[ParameterId::tau] = 119;
    state.controllers[ParameterId::thickness] = 1;
    CHECK(parseState(encodeState(state))->controllers == state.controllers);
    CHECK(encodeState(testState()).find("controllers") == std::string::npos);
}

TEST_CASE("Any truncated state is refused") {
    auto state = testState();
    state.objects.resize(1);
    const auto good = encodeState(state);
    for (std::size_t length = 0; length < good.size(); ++length)
        REQUIRE_FALSE(parseState(std::string_view(good).substr(0, length)));
}

TEST_CASE("Random bytes and random damage never crash the reader") {
    std::mt19937 random(11);
    auto state = testState();
    state.objects.resize(2);
    const auto good = encodeState(state);
    for (int i = 0; i < 2000; ++i) {
        std::string noise(random() % 500, '\0');
        for (char& c : noise)
            c = static_cast<char>(random());
        CHECK_FALSE(parseState(noise));
        auto damaged = good;
        for (int flip = 0; flip < 3; ++flip)
            damaged[random() % damaged.size()] = static_cast<char>(random());
        if (const auto read = parseState(damaged))
            for (const auto& info : parameterTable()) {
                const double value = read->parameters[info.parameter];
                REQUIRE((value >= info.minimum && value <= info.maximum));
            }
    }
}
