#include "Sampling/SfzText.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;

namespace {

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

const std::vector<PlannedSample> oneKey = planSamples(std::vector{60}, {.velocities = 2});

} // namespace

TEST_CASE("An SFZ file takes the gain back and maps keys and velocities") {
    const auto text = sfzText({.name = "Bar",
                               .folder = "bar/",
                               .ending = ".flac",
                               .gainDecibels = 6.5,
                               .tailDecibels = -60,
                               .keysHavePitches = true,
                               .releaseSeconds = {}},
                              oneKey);
    CHECK(contains(text, "\nvolume=-6.5\n"));
    CHECK(contains(text, "\namp_veltrack=0\n"));
    CHECK(contains(text, "\nloop_mode=one_shot\n"));
    CHECK(contains(text, "lokey=60 hikey=60 pitch_keycenter=60 lovel=65 hivel=127\n"
                         "<region> sample=bar/060-C4-v127-r1.flac\n"));
    CHECK_FALSE(contains(text, "seq_"));
    CHECK_FALSE(contains(text, "pitch_keytrack"));
}

TEST_CASE("An SFZ file lets round robins take turns") {
    const auto plan = planSamples(std::vector{60}, {.velocities = 1, .roundRobins = 2});
    const auto text =
        sfzText({.name = "Bar", .folder = "", .ending = ".wav", .releaseSeconds = {}}, plan);
    CHECK(contains(text, "hivel=127 seq_length=2\n"
                         "<region> seq_position=1 sample=060-C4-v127-r1.wav\n"
                         "<region> seq_position=2 sample=060-C4-v127-r2.wav\n"));
}

TEST_CASE("An SFZ file damps released keys, and keeps keys without pitches at their samples") {
    const auto text = sfzText({.name = "Plate",
                               .folder = "",
                               .ending = ".wav",
                               .keysHavePitches = false,
                               .releaseSeconds = 0.25},
                              oneKey);
    CHECK(contains(text, "\nloop_mode=no_loop\nampeg_release=0.25\n"));
    CHECK(contains(text, "\npitch_keytrack=0\n"));
}

TEST_CASE("A name cannot break out of its comment in an SFZ file") {
    const auto text = sfzText(
        {.name = "a\n<region> sample=x", .folder = "", .ending = ".wav", .releaseSeconds = {}}, {});
    CHECK_FALSE(contains(text, "\n<region>"));
}
