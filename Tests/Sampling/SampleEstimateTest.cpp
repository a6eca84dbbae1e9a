#include "Sampling/SampleEstimate.h"

#include "Object/WorkTeam.h"
#include "Sampling/SampleFolder.h"
#include "Sampling/SampledBar.h"
#include "Support/TestFolder.h"

#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;

TEST_CASE("An estimate is near the length and the bytes of the export") {
    const auto task = taskOfKeys(sampledBar(), std::vector{60}, {.velocities = 4}, ".wav");
    const auto folder = testFolder() / "estimated";
    std::filesystem::create_directories(folder);
    const SampleExportSettings settings{.folder = folder, .bitDepth = 16, .longestSeconds = 3};
    const auto estimate = estimateSamples(task, settings);
    REQUIRE(estimate);
    WorkTeam team(1);
    REQUIRE(exportTask(task, settings, team));
    double bytes = 0, seconds = 0;
    for (const auto& job : task.jobsIn(folder))
        bytes += static_cast<double>(std::filesystem::file_size(job.file));
    const auto figures = figuresOf(task.jobsIn(folder));
    REQUIRE(figures);
    for (const auto& each : *figures)
        seconds += each.seconds;
    CHECK(estimate->samples == 4);
    CHECK(std::abs(estimate->seconds / seconds - 1) < 0.05);
    CHECK(std::abs(estimate->bytes / bytes - 1) < 0.05);
}

TEST_CASE("FLAC files are estimated smaller than WAV files") {
    const auto bytes = [](const char* ending) {
        return estimateSamples(taskOfKeys(sampledBar(), std::vector{60}, {.velocities = 1}, ending),
                               {.longestSeconds = 1})
            .value()
            .bytes;
    };
    CHECK(bytes(".flac") < 0.5 * bytes(".wav"));
    CHECK(bytes(".flac") > 0.1 * bytes(".wav"));
}

TEST_CASE("An estimate of one sample has its length, and can be cancelled") {
    const auto task = taskOfKeys(sampledBar(), std::vector{60}, {.velocities = 1}, ".wav");
    const auto estimate = estimateSamples(task, {.longestSeconds = 0.1});
    REQUIRE(estimate);
    CHECK(estimate->samples == 1);
    CHECK(std::abs(estimate->seconds - 0.1) < 0.001);
    const std::atomic<bool> cancelled{true};
    const auto stopped = estimateSamples(task, {}, {.progress = {}, .cancelled = &cancelled});
    REQUIRE(!stopped);
    CHECK(isCancellation(stopped.error()));
}
