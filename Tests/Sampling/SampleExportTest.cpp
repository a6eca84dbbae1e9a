#include "Sampling/SampleExport.h"

#include "AudioFiles/AudioFileReader.h"
#include "Object/FileBytes.h"
#include "Object/TextFile.h"
#include "Object/WorkTeam.h"
#include "Sampling/SampledBar.h"
#include "Support/TestFolder.h"

#include <algorithm>
#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;

namespace {

std::vector<SampleJob> jobsIn(const std::filesystem::path& folder) {
    std::vector<SampleJob> jobs;
    for (const int velocity : {40, 80, 127})
        for (const std::uint64_t turn : {0u, 1u})
            jobs.push_back(
                {.strike = {.by = SampledStrike::KeyStrike{.key = 60, .velocity = velocity},
                            .turn = turn},
                 .file = folder /
                         ("v" + std::to_string(velocity) + "-r" + std::to_string(turn) + ".wav")});
    return jobs;
}

Result<ExportedSamples> exportTo(const std::filesystem::path& folder,
                                 const SampleExportSettings& settings = {},
                                 unsigned threads = 1,
                                 const WorkControl& control = {}) {
    WorkTeam team(threads);
    auto here = settings;
    here.folder = folder;
    return exportSamples(sampledBar(), jobsIn(folder), here, team, control);
}

std::vector<std::string> bytesIn(const std::filesystem::path& folder) {
    std::vector<std::string> bytes;
    for (const auto& job : jobsIn(folder))
        bytes.push_back(readBytes(job.file, 1 << 24).value_or(""));
    return bytes;
}

double peakOf(const std::filesystem::path& file) {
    double peak = 0;
    const auto sound = readChannels(file);
    REQUIRE(sound);
    for (const float sample : sound->samples)
        peak = std::max(peak, std::abs(static_cast<double>(sample)));
    return peak;
}

} // namespace

TEST_CASE("Exported samples do not depend on the threads") {
    const auto one = emptyFolder("one"), four = emptyFolder("four");
    REQUIRE(exportTo(one));
    REQUIRE(exportTo(four, {}, 4));
    CHECK((bytesIn(one) == bytesIn(four)));
}

TEST_CASE("The loudest strike has the headroom, and all samples the same gain") {
    const auto folder = emptyFolder("gain");
    const auto exported = exportTo(folder);
    REQUIRE(exported);
    CHECK(exported->clipped == 0);
    const double loudest = 20 * std::log10(peakOf(folder / "v127-r0.wav"));
    CHECK(loudest <= headroomDecibels);
    CHECK(loudest > headroomDecibels - 0.2);
    for (const int velocity : {40, 80}) {
        const auto strike =
            SampledStrike{.by = SampledStrike::KeyStrike{.key = 60, .velocity = velocity}};
        const auto own = static_cast<double>(sampleStrike(sampledBar(), strike, -60, 60)->peak());
        const double ratio = peakOf(folder / ("v" + std::to_string(velocity) + "-r0.wav")) / own;
        CHECK(std::abs(20 * std::log10(ratio) - exported->gainDecibels) < 0.01);
    }
}

TEST_CASE("An interrupted export goes on with the files that are missing") {
    const auto whole = emptyFolder("whole"), folder = emptyFolder("interrupted");
    REQUIRE(exportTo(whole)->rendered == 6);
    std::atomic<bool> cancelled{false};
    const auto stopped = exportTo(
        folder, {}, 1,
        {.progress = [&](double fraction, std::string_view) { cancelled = fraction > 0.4; },
         .cancelled = &cancelled});
    REQUIRE(!stopped);
    CHECK(isCancellation(stopped.error()));
    const auto finished = std::ranges::count_if(
        jobsIn(folder), [](const auto& job) { return std::filesystem::exists(job.file); });
    CHECK(finished > 0);
    CHECK(finished < 6);
    CHECK(exportTo(folder)->rendered == 6 - static_cast<std::size_t>(finished));
    CHECK((bytesIn(folder) == bytesIn(whole)));
}

TEST_CASE("Samples of other settings are not mixed in one folder") {
    const auto folder = emptyFolder("other");
    REQUIRE(exportTo(folder));
    const auto before = bytesIn(folder);
    for (const auto& settings :
         {SampleExportSettings{.bitDepth = 16}, SampleExportSettings{.tailDecibels = -50},
          SampleExportSettings{.gainDecibels = 1.5}}) {
        const auto refused = exportTo(folder, settings);
        REQUIRE(!refused);
        CHECK(refused.error().message ==
              folder.string() + ": it holds samples with other settings; choose another folder");
    }
    CHECK((bytesIn(folder) == before));
}

TEST_CASE("Samples that clip are counted") {
    const auto exported = exportTo(emptyFolder("loud"), {.gainDecibels = 60});
    REQUIRE(exported);
    CHECK(exported->clipped == 6);
}
