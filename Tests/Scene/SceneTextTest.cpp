// Tests the scene file parser and its errors.
#include "Scene/SceneText.h"

#include <catch2/catch_test_macros.hpp>
#include <string>

using namespace idiophone;

namespace {

/// Returns a scene of a ball on a table, with a member replaced or added.
std::string sceneWith(const std::string& members,
                      const std::string& bodies = R"([{"kind": "ball", "at": [0, 0, 1]}])") {
    return R"({"format": "idiophone-scene", "version": 1, "name": "Test", "kinds": [
        {"name": "table", "object": "table", "fixed": true},
        {"name": "ball", "ball": {"radius": 0.01, "material": "Steel"}}],
        "bodies": )" +
           bodies + members + "}";
}

std::string faultOf(const std::string& text) {
    const auto scene = parseScene(text, "test.json");
    return scene ? "" : scene.error().message;
}

} // namespace

TEST_CASE("A hand is parsed, and its errors name the place") {
    const auto sceneWith = [](const std::string& hand) {
        return parseScene(R"({"format": "idiophone-scene", "version": 1, "name": "x",
            "kinds": [{"name": "bell", "object": "handbell", "fixed": true},
                      {"name": "rod", "ball": {"radius": 0.01, "material": "Steel"}}],
            "bodies": [{"kind": "bell"}], "hand": )" +
                              hand + "}",
                          "x.json");
    };
    const auto read = sceneWith(R"({"kind": "bell", "tool": "rod", "taps": [[0.5, 0, 0.1, 0, 2]],
        "path": [[1, 0.1, 0, 0, 3], [2, 0, 0.1, 0, 0]]})");
    REQUIRE(read);
    REQUIRE(read->hand);
    CHECK(read->hand->kind == 0);
    CHECK(read->hand->tool == 1);
    CHECK(read->hand->taps.front().metresPerSecond == 2);
    CHECK(read->hand->path.front().newtons == 3);
    CHECK(read->hand->path.back().pointMetres == Eigen::Vector3d(0, 0.1, 0));
    for (const auto& [hand, fault] :
         {std::pair(R"({"kind": "rod", "tool": "rod"})", "hand.kind is a ball"),
          {R"({"kind": "bell", "tool": "bell"})", "hand.tool is fixed"},
          {R"({"kind": "bell", "tool": "rod", "path": [[1, 2]]})", "hand.path[0] is not a list of"},
          {R"({"kind": "bell", "tool": "rod", "taps": [[1, 0, 0, 0, 0]]})", "hand.taps[0][4]"},
          {R"({"kind": "bell", "tool": "rod", "path": [[1, 0, 0, 0, 1], [1, 0, 0, 0, 1]]})",
           "hand.path[1] is not later"}}) {
        const auto refused = sceneWith(hand);
        REQUIRE_FALSE(refused);
        INFO(refused.error().message);
        CHECK(refused.error().message.find(fault) != std::string::npos);
    }
}

TEST_CASE("A scene's members are parsed") {
    const auto scene =
        parseScene(sceneWith(R"(, "seconds": 3, "seed": 7, "steps_per_second": 4000, "gravity": 1.6,
                     "kicks": [{"kind": "ball", "time": 2, "velocity": [0, 0, 3],
                                "velocity_scatter": [1, 1, 0]}],
                     "listener": {"at": [0, -2, 1], "towards": [0, 0, 0]},
                     "parameters": {"tau": 2, "level": -20})",
                             R"([{"kind": "ball", "count": 3, "over": 1, "at": [0, 0, 1],
                       "turned_at_random": true, "spin": [0, 0, 2]}])"),
                   "test.json");
    REQUIRE(scene);
    CHECK(scene->seconds == 3);
    CHECK(scene->seed == 7);
    CHECK(scene->stepsPerSecond == 4000);
    CHECK(scene->gravityMetresPerSecond2 == 1.6);
    REQUIRE(scene->kinds.size() == 2);
    CHECK(scene->kinds[0].isFixed);
    CHECK(scene->kinds[1].form == BodyForm::sphere);
    REQUIRE(scene->releases.size() == 1);
    CHECK(scene->releases[0].kind == 1);
    CHECK(scene->releases[0].count == 3);
    CHECK(scene->releases[0].isTurnedAtRandom);
    CHECK(scene->releases[0].spinTurnsPerSecond.mean.z() == 2);
    REQUIRE(scene->kicks.size() == 1);
    CHECK(scene->kicks[0].velocityMetresPerSecond.reach.x() == 1);
    CHECK(scene->listener.positionMetres.y() == -2);
    CHECK(scene->parameters[ParameterId::tau] == 2);
}

TEST_CASE("A bad scene gets one sentence with the place in the file") {
    CHECK(faultOf("{\n  \"format\": \"idiophone-scene\",\n  oops}") ==
          "test.json: it is not JSON (line 3, column 3)");
    CHECK(faultOf("[1, 2]") == "test.json: it is not an Idiophone scene");
    CHECK(faultOf(R"({"format": "idiophone-scene", "version": 2, "name": "x"})") ==
          "test.json: it was made by a newer Idiophone (scene version 2)");
    CHECK(faultOf(sceneWith(R"(, "wind": 3)")) == "test.json: it has no 'wind'");
    CHECK(faultOf(sceneWith(R"(, "seconds": -1)")) ==
          "test.json: seconds is not between 0.001 and 3600");
    CHECK(faultOf(sceneWith(R"(, "seed": 1.5)")) == "test.json: seed is not a whole number");
    CHECK(faultOf(sceneWith("", R"([{"kind": "cup"}])")) ==
          "test.json: bodies[0].kind is 'cup', which is none of the kinds");
    CHECK(faultOf(sceneWith("", R"([{"kind": "ball"}, {"kind": "ball", "at": [0, "a", 1]}])")) ==
          "test.json: bodies[1].at[1] is not a number");
    CHECK(faultOf(sceneWith("", R"([{"kind": "ball", "velocity": [0, 1]}])")) ==
          "test.json: bodies[0].velocity is not a list of three numbers [x, y, z]");
    CHECK(faultOf(sceneWith("", R"([{"kind": "ball", "count": 10001}])")) ==
          "test.json: bodies[0].count is not between 1 and 10000");
    CHECK(faultOf(sceneWith("", "[]")) ==
          "test.json: it has nothing that moves: neither 'bodies' nor 'notes'");
    CHECK(faultOf(sceneWith(R"(, "kicks": [{"kind": "table", "time": 1}])")) ==
          "test.json: kicks[0].kind is fixed and cannot be thrown");
    CHECK(faultOf(sceneWith(R"(, "parameters": {"tau": "much"})")) ==
          "test.json: parameters.tau is a value that it cannot take");
    CHECK(faultOf(sceneWith(R"(, "parameters": {"reverb": 1})")) ==
          "test.json: parameters has no 'reverb'");
    CHECK(faultOf(sceneWith(R"(, "listener": {"at": [0, 0, 0], "towards": [0, 0, 0]})")) ==
          "test.json: listener is at the place it looks towards");
}

TEST_CASE("The members of a kind are checked") {
    const auto faultOfKind = [](const std::string& kind) {
        return faultOf(R"({"format": "idiophone-scene", "version": 1, "name": "x", "kinds": [)" +
                       kind + R"(], "bodies": [{"kind": "a"}]})");
    };
    CHECK(faultOfKind(R"({"name": "a", "object": "table"})").empty());
    CHECK(faultOfKind(R"({"name": "a"})") == "test.json: kinds[0] needs either 'object' or 'ball'");
    CHECK(faultOfKind(R"({"name": "a", "object": "table", "form": "cube"})") ==
          "test.json: kinds[0].form is 'cube' and none of hull, ring, sphere, cylinder, surface, "
          "mesh and ground");
    CHECK(faultOfKind(R"({"name": "a", "object": "table", "form": "ground"})") ==
          "test.json: kinds[0].form is for fixed bodies only");
    CHECK(faultOfKind(R"({"name": "a", "ball": {"radius": 0.1, "material": "Cheese"}})") ==
          "test.json: kinds[0].ball.material is 'Cheese', which is no material");
    CHECK(faultOfKind(R"({"name": "a", "object": "ring", "passes": ["b"]})") ==
          "test.json: kinds[0].passes[0] is 'b', which is none of the kinds");
    CHECK(faultOfKind(R"({"name": "a", "object": "ring"}, {"name": "a", "object": "ring"})") ==
          "test.json: kinds[1].name is 'a' like that of another kind");
    CHECK(faultOfKind(R"({"name": "a", "object": "ring", "surface": {"format": "x"}})") ==
          "test.json: kinds[0].surface is not an Idiophone surface");
}

TEST_CASE("A scene file that is too large is refused before it is parsed") {
    const std::string blanks(largestSceneBytes, ' ');
    CHECK(faultOf(blanks + sceneWith("")) == "test.json: it is too large for a scene");
    CHECK(faultOf(sceneWith("")).empty());
}
