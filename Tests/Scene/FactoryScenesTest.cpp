// Tests the factory scenes.
#include "Scene/FactoryScenes.h"
#include "Instrument/ObjectLibrary.h"

#include "Scene/SceneFile.h"
#include "Scene/SceneSimulation.h"

#include <catch2/catch_test_macros.hpp>
#include <filesystem>
#include <set>

using namespace idiophone;

TEST_CASE("Every scene of the folder is in the program under a unique name") {
    std::set<std::string> names;
    std::size_t files = 0;
    for (const auto& file : std::filesystem::directory_iterator(
             std::filesystem::path(IDIOPHONE_SOURCE_DIR) / "Resources" / "Scenes")) {
        INFO(file.path().filename().string());
        const auto scene = readSceneFile(file.path());
        REQUIRE(scene);
        CHECK(names.insert(scene->name).second);
        CHECK_FALSE(scene->description.empty());
        CHECK(findFactoryScene(scene->name) != nullptr);
        ++files;
    }
    CHECK(factoryScenes().size() == files);
    CHECK(findFactoryScene("dice on a XYLOPHONE") == &factoryScenes().front());
    CHECK(findFactoryScene("nothing") == nullptr);
}

TEST_CASE("Every factory scene loads, and a body is struck in its first second") {
    for (const auto& scene : factoryScenes()) {
        INFO(scene.name);
        const auto assets = SceneAssets::make(scene, ObjectLibrary::shared());
        REQUIRE(assets);
        SceneSimulation motion(*assets, {.notes = {{0.2, 72, 100}}});
        motion.advanceTo(1);
        CHECK(motion.takeImpact(1));
        CHECK(motion.figures().bodies > (scene.hand ? 0 : 1));
    }
}
