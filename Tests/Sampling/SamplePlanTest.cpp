#include "Sampling/SamplePlan.h"

#include <catch2/catch_test_macros.hpp>
#include <numeric>

using namespace idiophone;

TEST_CASE("Layers of velocity end at evenly spread velocities up to 127") {
    CHECK(layerVelocities(1) == std::vector{127});
    CHECK(layerVelocities(5) == std::vector{25, 51, 76, 102, 127});
    std::vector<int> all(127);
    std::iota(all.begin(), all.end(), 1);
    CHECK(layerVelocities(127) == all);
}

TEST_CASE("Every key and velocity plays exactly one sample in each turn") {
    std::vector<int> keys(24);
    std::iota(keys.begin(), keys.end(), 40);
    keys.erase(keys.begin() + 5); // a key without an object
    for (const int every : {1, 3, 50})
        for (const int velocities : {1, 4}) {
            const auto plan =
                planSamples(keys, {.every = every, .velocities = velocities, .roundRobins = 2});
            for (int key = 40; key < 64; ++key)
                for (int velocity = 1; velocity <= 127; ++velocity)
                    for (int turn = 1; turn <= 2; ++turn) {
                        int count = 0;
                        for (const auto& sample : plan)
                            count += sample.lowestKey <= key && key <= sample.highestKey &&
                                     sample.lowestVelocity <= velocity &&
                                     velocity <= sample.velocity && sample.roundRobin == turn;
                        REQUIRE(count == 1);
                    }
        }
}

TEST_CASE("A key without its own sample plays the nearest one") {
    const std::vector keys{60, 61, 62, 63, 64, 65};
    const auto plan = planSamples(keys, {.every = 3, .velocities = 1});
    REQUIRE(plan.size() == 2);
    CHECK(plan[0].key == 60);
    CHECK(plan[0].highestKey == 61);
    CHECK(plan[1].lowestKey == 62);
    CHECK(plan[1].key == 63);
    CHECK(plan[1].highestKey == 65);
}

TEST_CASE("Samples are named by key, velocity and turn") {
    const std::vector keys{61};
    const auto plan = planSamples(keys, {.velocities = 2, .roundRobins = 2});
    REQUIRE(plan.size() == 4);
    CHECK(plan[0].name == "061-Cs4-v064-r1");
    CHECK(plan[3].name == "061-Cs4-v127-r2");
}
