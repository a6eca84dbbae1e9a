#include "Sampling/SampleFolder.h"

#include "AudioFiles/AudioFileReader.h"
#include "Object/TextFile.h"
#include "Object/WorkTeam.h"
#include "Sampling/SampledBar.h"
#include "Support/TestFolder.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;

namespace {

Result<SampleFolder> exportTo(const std::filesystem::path& folder, const SampleTask& task) {
    std::filesystem::create_directories(folder);
    WorkTeam team(1);
    return exportTask(task, {.folder = folder, .tailDecibels = -40, .longestSeconds = 1}, team);
}

} // namespace

TEST_CASE("An export of keys writes an SFZ file that names every sample") {
    auto bar = sampledBar();
    bar.preset.name = "Bar: one";
    const auto task = taskOfKeys(bar, std::vector{60}, {.velocities = 2}, ".wav");
    const auto folder = testFolder() / "keys";
    CHECK_FALSE(holdsSamples(folder));
    const auto made = exportTo(folder, task);
    REQUIRE(made);
    CHECK(holdsSamples(folder));
    CHECK(made->exported.rendered == 2);
    CHECK(made->figures.empty());
    CHECK(made->index == folder / "Bar_ one.sfz");
    const auto text = readTextFile(made->index);
    REQUIRE(text);
    for (const auto& sample : task.keys)
        CHECK(text->find("sample=" + sample.name + ".wav\n") != std::string::npos);
}

TEST_CASE("An export of places writes a table of the files as they lie on the disk") {
    const auto task = taskOfPlaces(sampledBar(), 0, 2, 1, ".wav");
    REQUIRE(task);
    const auto folder = testFolder() / "places";
    const auto made = exportTo(folder, *task);
    REQUIRE(made);
    CHECK(made->index == folder / "samples.csv");
    REQUIRE(made->figures.size() == 2);
    const auto sound = readChannels(folder / "p01-v127.wav");
    REQUIRE(sound);
    const double peak = static_cast<double>(*std::ranges::max_element(
        sound->samples, {}, [](float sample) { return std::abs(sample); }));
    CHECK(std::abs(made->figures[0].peakDecibels - 20 * std::log10(std::abs(peak))) < 1e-6);
    CHECK(made->figures[0].seconds ==
          static_cast<double>(sound->samples.size() / 2) / sound->sampleRateHz);
    const auto text = readTextFile(made->index);
    REQUIRE(text);
    CHECK(text->starts_with("file,x_m,y_m,z_m,velocity,peak_dbfs,loudest_moment_lufs,seconds\n"
                            "p01-v127.wav,"));
    CHECK(std::ranges::count(*text, '\n') == 3);
}

TEST_CASE("Samples of another tuning are not mixed in one folder") {
    auto bar = sampledBar();
    const auto folder = testFolder() / "tuned";
    REQUIRE(exportTo(folder, taskOfKeys(bar, std::vector{60}, {.velocities = 1}, ".wav")));
    bar.tuning.semitonesFromEqual[60] = 0.5;
    const auto refused =
        exportTo(folder, taskOfKeys(bar, std::vector{60}, {.velocities = 1}, ".wav"));
    REQUIRE(!refused);
    CHECK(refused.error().message.ends_with("choose another folder"));
}
