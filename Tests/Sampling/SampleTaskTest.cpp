#include "Sampling/SampleTask.h"

#include "Sampling/SampledBar.h"

#include <catch2/catch_test_macros.hpp>
#include <variant>

using namespace idiophone;
using namespace idiophone::test;

TEST_CASE("A task of keys has a file for each key, velocity and turn") {
    const auto task =
        taskOfKeys(sampledBar(), std::vector{60, 61}, {.velocities = 2, .roundRobins = 2}, ".flac");
    CHECK(task.places.empty());
    REQUIRE(task.keys.size() == 8);
    const auto jobs = task.jobsIn("folder");
    REQUIRE(jobs.size() == 8);
    CHECK(jobs[1].file == std::filesystem::path("folder") / "060-C4-v064-r2.flac");
    const auto& strike = std::get<SampledStrike::KeyStrike>(jobs[1].strike.by);
    CHECK(strike.key == 60);
    CHECK(strike.velocity == 64);
    CHECK(jobs[0].strike.turn == 0);
    CHECK(jobs[1].strike.turn == 1);
}

TEST_CASE("A task of places strikes each place with each velocity") {
    const auto task = taskOfPlaces(sampledBar(), 0, 3, 2, ".wav");
    REQUIRE(task);
    CHECK(task->keys.empty());
    REQUIRE(task->places.size() == 6);
    CHECK(task->places[4].name == "p03-v064");
    CHECK(task->places[4].placeMetres == task->places[5].placeMetres);
    CHECK(task->places[0].placeMetres != task->places[2].placeMetres);
    const auto jobs = task->jobsIn("folder");
    CHECK(jobs[5].file == std::filesystem::path("folder") / "p03-v127.wav");
    CHECK(std::get<SurfaceStrike>(jobs[5].strike.by).velocity == 127);
    const auto tooMany = taskOfPlaces(sampledBar(), 0, 99, 2, ".wav");
    REQUIRE(!tooMany);
    CHECK(tooMany.error().message.starts_with("it has mode shapes at only "));
}

TEST_CASE("Only keys that play are sampled") {
    const auto bar = sampledBar();
    CHECK(playedKeys(*bar.instrument, 0, 127) == std::vector{60});
    CHECK(playedKeys(*bar.instrument, 61, 127).empty());
    CHECK(playedKeys(*bar.instrument, 60, 60) == ownKeys(*bar.instrument));
}

TEST_CASE("Strikes vary by spread or by chatter") {
    ParameterValues values;
    values.set(ParameterId::strikeSpread, 0);
    values.set(ParameterId::chatter, 0);
    CHECK_FALSE(strikesVary(values));
    values.set(ParameterId::chatter, 10);
    CHECK(strikesVary(values));
    values.set(ParameterId::chatter, 0);
    values.set(ParameterId::strikeSpread, 10);
    CHECK(strikesVary(values));
}
