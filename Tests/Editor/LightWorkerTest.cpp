// Tests of the light that is computed in the background.
#include "Editor/LightWorker.h"
#include "Support/WaitUntil.h"

#include <catch2/catch_test_macros.hpp>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr FloorArea area{
    .left = -2, .front = -2, .width = 4, .depth = 4, .height = 0, .columns = 60, .rows = 40};

/// Level triangles above each other.
std::vector<SceneVertex> pile(std::size_t triangles) {
    std::vector<SceneVertex> vertices;
    for (std::size_t i = 0; i < triangles; ++i)
        for (const auto& [x, y] : {std::pair(-1.0f, -1.0f), {1.0f, -1.0f}, {0.0f, 1.0f}})
            vertices.push_back({{x, y, 0.2f + 0.01f * float(i)}, {0, 0, 1}});
    return vertices;
}

} // namespace

TEST_CASE("The light of a scene arrives from another thread, and is announced once") {
    const auto vertices = pile(5);
    std::atomic<int> announced{0};
    LightWorker worker([&] { ++announced; });
    CHECK(worker.light() == nullptr);
    worker.begin(vertices, area);
    waitUntil([&] { return announced > 0; });
    const auto expected = sceneLight(vertices, area).value();
    REQUIRE(worker.light() != nullptr);
    CHECK(worker.light()->sky == expected.sky);
    CHECK(worker.light()->floor == expected.floor);
    CHECK(announced == 1);
}

TEST_CASE("The light of a new scene never comes from an older one") {
    LightWorker worker([] {});
    for (std::size_t turn = 0; turn < 20; ++turn) {
        for (const std::size_t triangles : {turn + 30, turn + 1}) {
            worker.begin(pile(triangles), area);
            CHECK((worker.light() == nullptr || worker.light()->sky.size() == 3 * triangles));
        }
        if (turn % 2 == 0) // else the next request finds the worker at work
            waitUntil([&] { return worker.light() != nullptr; });
    }
    waitUntil([&] { return worker.light() != nullptr; });
    CHECK(worker.light()->sky.size() == 3 * 20);
}

TEST_CASE("An abandoned light is not computed to its end") {
    const std::atomic<bool> isAbandoned{true};
    CHECK_FALSE(sceneLight(pile(1), area, &isAbandoned));
}
