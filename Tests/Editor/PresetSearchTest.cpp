#include "Editor/PresetSearch.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;

namespace {

ShelvedPreset bowl() {
    return {.id = "Glass/Blue bowl.json",
            .name = "Blue Bowl",
            .author = "Änne Müller",
            .description = "Thin glass, struck at the rim.",
            .tags = {"glass", "zones"},
            .folder = "Glass",
            .isFactory = false,
            .isFavourite = false,
            .fault = {}};
}

} // namespace

TEST_CASE("A search finds presets that contain every word, ignoring case") {
    for (const auto* words : {"", "  ", "bowl", "BLUE", "rim zones", "ände", "änne", "ÄNNE müller",
                              "lass ue", "glass glass"}) {
        INFO(words);
        CHECK((searchErrors(bowl(), juce::String::fromUTF8(words)) == 0) ==
              (std::string(words) != "ände"));
    }
    CHECK_FALSE(searchErrors(bowl(), "bowl steel"));
    CHECK_FALSE(searchErrors(bowl(), "bluebowl"));
    CHECK_FALSE(searchErrors({}, "x"));
    CHECK(searchErrors({}, "") == 0);
}

TEST_CASE("Each tag is listed once: words for sound in their order, then the most frequent") {
    auto first = bowl(), second = bowl(), third = bowl();
    second.tags = {"Zones", "metal", " ", "long", "bright"};
    third.tags = {"zones", "bells", "long", "Dark"};
    CHECK(tagsOf({first, second, third}) ==
          juce::StringArray({"dark", "bright", "long", "zones", "bells", "glass", "metal"}));
    CHECK(tagsOf({}).isEmpty());
}

TEST_CASE("Searching a text takes linear time") {
    auto wordy = bowl();
    wordy.description = std::string(4'000'000, 'X') + " end"; // an hour in quadratic time
    CHECK(searchErrors(wordy, "xxx END") == 0);
    CHECK_FALSE(searchErrors(wordy, "y"));
    wordy.name = wordy.description;
    CHECK_FALSE(searchErrors(wordy, "yyyyyyyyyy"));
}

TEST_CASE("A search forgives one typing error in a word from 4 letters, two from 8") {
    auto preset = bowl();
    preset.name = "Vibraphone, Marimba-Xylophone (Glockenspiel)";
    for (const auto* words :
         {"vibrafone", "vibrafon", "vibaphone", "marinba", "marmba", "xylofon", "zylophone",
          "glockenspeil", "glokenspeil", "glsas", "vibrafone gass"}) {
        INFO(words);
        CHECK(searchErrors(preset, words).value_or(0) > 0);
    }
    for (const auto* words : {"zno", "marnbo", "glogenspeel", "vibrafone steel", "thim"}) {
        INFO(words); // the last is wrong in the description only
        CHECK_FALSE(searchErrors(preset, words));
    }
    CHECK(searchErrors(preset, "glokenspeil") > searchErrors(preset, "glockenspeil"));
}
