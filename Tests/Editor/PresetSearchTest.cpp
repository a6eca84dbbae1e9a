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
        CHECK(matchesSearch(bowl(), juce::String::fromUTF8(words)) ==
              (std::string(words) != "ände"));
    }
    CHECK_FALSE(matchesSearch(bowl(), "bowl steel"));
    CHECK_FALSE(matchesSearch(bowl(), "bluebowl"));
    CHECK_FALSE(matchesSearch({}, "x"));
    CHECK(matchesSearch({}, ""));
}

TEST_CASE("Each tag is listed once, the most frequent first") {
    auto first = bowl(), second = bowl(), third = bowl();
    second.tags = {"Zones", "metal", " "};
    third.tags = {"zones", "bells"};
    CHECK(tagsOf({first, second, third}) ==
          juce::StringArray({"zones", "bells", "glass", "metal"}));
    CHECK(tagsOf({}).isEmpty());
}

TEST_CASE("Searching a text takes linear time") {
    auto wordy = bowl();
    wordy.description = std::string(4'000'000, 'X') + " end"; // an hour in quadratic time
    CHECK(matchesSearch(wordy, "xxx END"));
    CHECK_FALSE(matchesSearch(wordy, "y"));
}
