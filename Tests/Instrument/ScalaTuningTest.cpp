#include "Instrument/ScalaTuning.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <string>

using namespace idiophone;
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr double middleCHz = 261.6255653005986;

ScalaTuning scaled(const std::string& text) {
    return {.scale = {.name = "test.scl", .text = text}, .mapping = {}};
}

ScalaTuning mapped(const std::string& scale, const std::string& mapping) {
    return {.scale = {.name = "test.scl", .text = scale},
            .mapping = {.name = "test.kbm", .text = mapping}};
}

double hertz(const ScalaTuning& tuning, int note) {
    const auto keys = keyTuning(tuning);
    REQUIRE(keys);
    REQUIRE_FALSE(keys->unmapped[static_cast<std::size_t>(note)]);
    const double semitones = note - 69 + keys->semitonesFromEqual[static_cast<std::size_t>(note)];
    return 440 * std::exp2(semitones / 12);
}

std::string equalSteps(int count) {
    std::string text = "! equal.scl\n!\nEqual steps\n" + std::to_string(count) + "\n!\n";
    for (int step = 1; step < count; ++step)
        text += std::to_string(1200.0 * step / count) + "\n";
    return text + "2/1\n";
}

const std::string just = "! just.scl\n!\nJust intonation in C\n 12\n!\n 16/15\n 9/8\n 6/5\n 5/4\n"
                         " 4/3\n 45/32\n 3/2\n 8/5\n 5/3\n 9/5\n 15/8\n 2/1\n";

/// Seven degrees on the white keys, none on the black ones.
const std::string whiteKeys = "! white.kbm\n12\n0\n127\n60\n69\n440.0\n7\n"
                              "0\nx\n1\nx\n2\n3\nx\n4\nx\n5\nx\n6\n";

void checkRefused(const ScalaTuning& tuning, const std::string& because) {
    const auto keys = keyTuning(tuning);
    REQUIRE_FALSE(keys);
    const auto& sentence = keys.error().message;
    INFO(sentence);
    CHECK_THAT(sentence, ContainsSubstring(because));
    CHECK(sentence.back() == '.');
    CHECK(sentence.find('\n') == std::string::npos);
}

} // namespace

TEST_CASE("Without files, or with twelve equal steps, every key keeps its pitch to the last bit") {
    CHECK(keyTuning({}) == KeyTuning{});
    CHECK(keyTuning(scaled(equalSteps(12))) == KeyTuning{});
}

TEST_CASE("A ratio may have blanks around its slash, and text behind it") {
    for (const auto* second : {"9 / 8", " 9/ 8", "9 /8", "\t9\t/\t8 major tone", "9 / 8! tone",
                               "9/8", "9/8 a / b", "203.910002 cents of 9 / 8"})
        CHECK(hertz(scaled(std::string("Blanks\n2\n") + second + "\n2 / 1\n"), 61) ==
              Approx(middleCHz * 9 / 8));
    for (const auto* text : {"2 / an octave", "2 octaves 1 / 2", "2 ! 3 / 2"})
        CHECK(hertz(scaled(std::string("Text\n1\n") + text + "\n"), 61) == Approx(middleCHz * 2));
    checkRefused(scaled("Half\n1\n9/\n"), "neither cents nor a ratio");
}

TEST_CASE("A scale of ratios begins at middle C") {
    const auto tuning = scaled(just);
    CHECK(hertz(tuning, 60) == Approx(middleCHz));
    CHECK(hertz(tuning, 64) == Approx(middleCHz * 5 / 4));
    CHECK(hertz(tuning, 67) == Approx(middleCHz * 3 / 2));
    CHECK(hertz(tuning, 76) == Approx(middleCHz * 5 / 2));
    CHECK(hertz(tuning, 59) == Approx(middleCHz * 15 / 16));
    CHECK(scaleTitle(tuning) == "Just intonation in C");
}

TEST_CASE("Thirty-one steps to the octave use thirty-one keys") {
    const auto tuning = scaled(equalSteps(31));
    CHECK(hertz(tuning, 60 + 31) == Approx(2 * middleCHz));
    CHECK(hertz(tuning, 60 - 31) == Approx(middleCHz / 2));
    CHECK(hertz(tuning, 61) == Approx(middleCHz * std::exp2(1 / 31.0)));
}

TEST_CASE("A scale repeats at its last note, whether it is an octave or not") {
    std::string thirteen = "Bohlen-Pierce\n13\n";
    for (int step = 1; step <= 13; ++step)
        thirteen += std::to_string(1901.955 * step / 13) + "\n";
    CHECK(hertz(scaled(thirteen), 60 + 13) == Approx(3 * middleCHz).epsilon(1e-6));
}

TEST_CASE("A mapping without a scale moves the reference") {
    const ScalaTuning tuning{.scale = {},
                             .mapping = {.name = "a.kbm", .text = "0\n0\n127\n60\n69\n432\n0\n"}};
    CHECK(hertz(tuning, 69) == Approx(432));
    CHECK(hertz(tuning, 57) == Approx(216));
    CHECK(scaleTitle(tuning) == "a.kbm");
}

TEST_CASE("A mapping assigns degrees to keys and leaves others without a pitch") {
    const auto tuning = mapped(equalSteps(7), whiteKeys);
    CHECK(hertz(tuning, 69) == Approx(440));
    CHECK(hertz(tuning, 71) == Approx(440 * std::exp2(1 / 7.0)));
    CHECK(hertz(tuning, 72) == Approx(440 * std::exp2(2 / 7.0)));
    CHECK(hertz(tuning, 60) == Approx(440 * std::exp2(-5 / 7.0)));
    CHECK(hertz(tuning, 57) == Approx(220));
    const auto keys = keyTuning(tuning);
    for (const std::size_t black : {61u, 63u, 66u, 68u, 70u, 73u})
        CHECK(keys->unmapped[black]);
    CHECK_FALSE(keys->unmapped[62]);
}

TEST_CASE("The reference note may lie outside the mapping's first repetition, on either side") {
    const std::string seven = "7\n0\n127\n60\nREFERENCE\n440\n7\n0\n1\n2\n3\n4\n5\n6\n";
    const int reference = GENERATE(40, 52, 60, 66, 67, 69, 95);
    auto mapping = seven;
    mapping.replace(mapping.find("REFERENCE"), 9, std::to_string(reference));
    const auto tuning = mapped(equalSteps(7), mapping);
    for (const int note : {reference - 8, reference - 1, reference, reference + 1, reference + 9})
        CHECK(hertz(tuning, note) == Approx(440 * std::exp2((note - reference) / 7.0)));
}

TEST_CASE("A mapping repeats at its formal octave, which may differ from the scale's last note") {
    // Twenty-four notes over two octaves; seven notes of the lower octave on seven keys.
    std::string two = "Two octaves\n24\n";
    for (int step = 1; step <= 24; ++step)
        two += std::to_string(100 * step) + ".\n";
    const auto white = mapped(two, "7\n0\n127\n60\n60\n261.6255653\n12\n0\n2\n4\n5\n7\n9\n11\n");
    CHECK(hertz(white, 62) == Approx(middleCHz * std::exp2(4 / 12.0)));
    CHECK(hertz(white, 67) == Approx(2 * middleCHz));
    CHECK(hertz(white, 72) == Approx(middleCHz * std::exp2(21 / 12.0)));
    CHECK(hertz(white, 53) == Approx(middleCHz / 2));
    // Every second note of a scale of twelve, over two of its octaves.
    const auto wide =
        mapped(equalSteps(12), "12\n0\n127\n60\n69\n440\n24\n0\n2\n4\n6\n8\n10\n12\n14\n"
                               "16\n18\n20\n22\n");
    CHECK(hertz(wide, 69) == Approx(440));
    CHECK(hertz(wide, 70) == Approx(440 * std::exp2(2 / 12.0)));
    CHECK(hertz(wide, 81) == Approx(1760));
    // Twelve of nineteen steps. Without a formal octave the mapping repeats at the scale's own.
    const auto nineteen =
        mapped(equalSteps(19),
               "12\n0\n127\n60\n60\n261.6255653\n0\n0\n1\n3\n5\n6\n8\n9\n11\n12\n14\n16\n17\n");
    CHECK(hertz(nineteen, 67) == Approx(middleCHz * std::exp2(11 / 19.0)));
    CHECK(hertz(nineteen, 72) == Approx(2 * middleCHz));
}

TEST_CASE("Keys missing at a mapping's end have no pitch, and a byte order mark is ignored") {
    const auto tuning =
        mapped("\xef\xbb\xbf! a.scl\nFifths\n1\n3/2\n", "3\n0\n127\n60\n60\n300\n1\n0\n");
    CHECK(hertz(tuning, 60) == Approx(300));
    CHECK(hertz(tuning, 63) == Approx(450));
    CHECK(keyTuning(tuning)->unmapped[61]);
    CHECK(keyTuning(tuning)->unmapped[62]);
    CHECK(scaleTitle(tuning) == "Fifths");
}

TEST_CASE("Lines may have any ending, and text after a number is ignored") {
    const auto plain = scaled("Fifths\n2\n3/2\n2/1\n");
    for (const std::string text : {"Fifths\r\n2\r\n3/2\r\n2/1\r\n", "Fifths\r2\r3/2\r2/1",
                                   "Fifths\n 2 notes\n"
                                   "3/2 ! 701.955 cents\n\n\t2/1 octave\n",
                                   "Fifths\n2\n701.9550008654\n1200.\nmore\n"}) {
        const auto tuning = scaled(text);
        CHECK(hertz(tuning, 61) == Approx(hertz(plain, 61)));
        CHECK(hertz(tuning, 62) == Approx(hertz(plain, 62)));
    }
}

TEST_CASE("The numbers of a ratio may be of any size") {
    CHECK(hertz(scaled("Comma\n1\n19073486328125/8796093022208\n"), 61) ==
          Approx(middleCHz * 19073486328125.0 / 8796093022208.0));
}

TEST_CASE("A key whose pitch would be inaudible has no pitch") {
    const auto keys = keyTuning(scaled("Octaves\n1\n2/1\n"));
    REQUIRE(keys);
    CHECK_FALSE(keys->unmapped[60]);
    CHECK_FALSE(keys->unmapped[68]);
    CHECK(keys->unmapped[69]); // 134 kHz
    CHECK(keys->unmapped[51]); // 0.5 Hz
    CHECK(keys->unmapped[0]);
}

TEST_CASE("A fault in a file is one sentence with the file's name and line") {
    checkRefused({.scale = {.name = "none.scl", .text = ""}, .mapping = {}}, "none.scl is empty");
    checkRefused(scaled("only a title\n"), "test.scl ends before the number of notes");
    checkRefused(scaled("title\nmany\n"), "test.scl, line 2: the number of notes is not a whole");
    checkRefused(scaled("title\n0\n"), "line 2");
    checkRefused(scaled("title\n99999999\n"), "1 to 1024");
    checkRefused(scaled("title\n2\n3/2\n"), "ends before note 2 of its 2");
    checkRefused(scaled("title\n1\n-3/2\n"), "line 3: note 1 of its 1 is neither cents nor");
    checkRefused(scaled("title\n1\n3/0\n"), "line 3");
    checkRefused(scaled("title\n1\nnan\n"), "line 3");
    checkRefused(scaled("title\n1\n1e300.\n"), "line 3");
    checkRefused(scaled("title\n1\n123456.7\n"), "more than twenty octaves");
    checkRefused(mapped(just, "12\n0\n127\n60\n"), "test.kbm ends before the reference note");
    checkRefused(mapped(just, "0\n0\n127\n60\n69\n0\n0\n"), "line 6: the reference frequency");
    checkRefused(mapped(just, "0\n0\n127\n60\n69\n-440\n0\n"), "line 6");
    checkRefused(mapped(just, "0\n0\n127\n60\n200\n440\n0\n"), "line 5: the reference note");
    checkRefused(mapped(just, "0\n0\n127\n60\n69\n440\n-1\n"), "line 7: the degree of the formal");
    checkRefused(mapped(just, "1\n0\n127\n60\n69\n440\n12\ny\n"), "neither x nor a degree");
    checkRefused(mapped(just, "1\n0\n127\n60\n69\n440\n12\n9999\n"), "line 8: key 1 of its 1");
    checkRefused(mapped(just, "2\n0\n127\n60\n61\n440\n12\n0\nx\n"), "reference note no degree");
}

TEST_CASE("A truncated file is read or refused with a sentence") {
    for (std::size_t length = 1; length < just.size(); ++length)
        if (const auto keys = keyTuning(scaled(just.substr(0, length))); !keys)
            CHECK_THAT(keys.error().message, ContainsSubstring("test.scl"));
    for (std::size_t length = 1; length < whiteKeys.size(); ++length)
        if (const auto keys = keyTuning(mapped(equalSteps(7), whiteKeys.substr(0, length))); !keys)
            CHECK_THAT(keys.error().message, ContainsSubstring("test.kbm"));
}
