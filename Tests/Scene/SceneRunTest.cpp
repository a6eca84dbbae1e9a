// Performances: songs as falling dice, slots, chance.
#include "Scene/SceneRun.h"
#include "Scene/FactoryScenes.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <map>

using namespace idiophone;
using Catch::Matchers::WithinAbs;

namespace {

std::shared_ptr<const SceneCast> castOf(const Scene& scene) {
    auto cast = SceneCast::make(scene, ObjectLibrary::shared());
    REQUIRE(cast);
    return *cast;
}

std::shared_ptr<const SceneCast> factoryCast(const char* name) {
    const auto* scene = findFactoryScene(name);
    REQUIRE(scene != nullptr);
    return castOf(*scene);
}

std::vector<SceneBlow> blowsUntil(SceneRun& motion, double seconds) {
    motion.advanceTo(seconds);
    std::vector<SceneBlow> blows;
    while (const auto blow = motion.takeBlow(seconds))
        blows.push_back(*blow);
    return blows;
}

double impulse(const SceneBlow& blow) {
    const auto& i = blow.strike.impulseNewtonSeconds;
    return std::hypot(i[0], i[1], i[2]);
}

} // namespace

TEST_CASE("Every note's die hits its bar within 2 ms of the score") {
    // A scale, repeated notes, a chord, and the first note at once.
    std::vector<SceneNote> notes;
    for (int k = 0; k < 25; ++k)
        notes.push_back({0.11 * k, 65 + k, 20 + 4 * k});
    for (int k = 0; k < 10; ++k)
        notes.push_back({3.0 + 0.13 * k, 72, 127});
    for (const int note : {72, 76, 79})
        notes.push_back({5, note, 1});
    const auto cast = factoryCast("Dice on a xylophone");
    SceneRun motion(cast, {.notes = notes});
    motion.advanceTo(5.5);
    CHECK_FALSE(motion.finished());
    const auto blows = blowsUntil(motion, 6.5);
    CHECK(motion.figures().notesLeftOut == 0);

    for (const auto& note : notes) {
        double nearest = 1;
        for (const auto& blow : blows) {
            const auto& struck = *cast->roles()[blow.role].kind.model->object;
            if (struck.name == "xylophone-" + std::to_string(note.note))
                nearest = std::min(nearest, std::abs(blow.seconds - note.seconds));
        }
        INFO(note.note << " at " << note.seconds);
        CHECK(nearest < 0.002);
    }
    CHECK(motion.finished());
}

TEST_CASE("A die falls from so high that its blow grows with the velocity") {
    const auto cast = factoryCast("Dice on a xylophone");
    double before = 0;
    for (const int velocity : {1, 32, 64, 96, 127}) {
        SceneRun motion(cast, {.notes = {{0.5, 72, velocity}}});
        const auto blows = blowsUntil(motion, 0.51);
        REQUIRE_FALSE(blows.empty());
        INFO(velocity);
        CHECK(impulse(blows.front()) > before);
        before = impulse(blows.front());
    }
}

TEST_CASE("Notes beyond the keyboard are left out and counted") {
    SceneRun motion(factoryCast("Dice on a xylophone"),
                    {.notes = {{1, 20, 100}, {1, 72, 100}, {2, 126, 9}}});
    CHECK(motion.figures().notesLeftOut == 2);
}

TEST_CASE("Blows come in order of time, whatever the steps in which they are asked for") {
    const auto cast = factoryCast("Shells in a room");
    SceneRun whole(cast), bits(cast);
    const auto expected = blowsUntil(whole, 2);
    std::vector<SceneBlow> found;
    for (double until = 0.00133; until < 2; until += 0.00133)
        for (const auto& blow : blowsUntil(bits, until))
            found.push_back(blow);
    for (const auto& blow : blowsUntil(bits, 2))
        found.push_back(blow);
    REQUIRE(found.size() == expected.size());
    CHECK(found.size() > 100);
    double before = 0;
    for (std::size_t k = 0; k < found.size(); ++k) {
        REQUIRE(found[k].seconds >= before);
        before = found[k].seconds;
        REQUIRE(found[k].seconds == expected[k].seconds);
        REQUIRE(found[k].slot == expected[k].slot);
        REQUIRE(found[k].strike.impulseNewtonSeconds == expected[k].strike.impulseNewtonSeconds);
    }
}

TEST_CASE("Another seed is another performance") {
    auto scene = *findFactoryScene("Shells in a room");
    SceneRun one(castOf(scene));
    scene.seed += 1;
    SceneRun other(castOf(scene));
    const auto first = blowsUntil(one, 1), second = blowsUntil(other, 1);
    REQUIRE_FALSE(first.empty());
    REQUIRE_FALSE(second.empty());
    CHECK(first.front().seconds != second.front().seconds);
}

TEST_CASE("Bodies that are thrown again move again") {
    const auto cast = factoryCast("Shells in a room");
    const double kick = cast->scene().kicks.front().seconds;
    SceneRun motion(cast);
    blowsUntil(motion, kick - 0.5);
    CHECK(blowsUntil(motion, kick).size() < 30);
    CHECK(blowsUntil(motion, kick + 1).size() > 100);
}

TEST_CASE("A scene that names what is not there says so") {
    const auto faultOf = [](auto change) {
        auto scene = *findFactoryScene("Dice on a xylophone");
        change(scene);
        const auto cast = SceneCast::make(scene, ObjectLibrary::shared());
        return cast ? "" : cast.error().message;
    };
    CHECK(faultOf([](Scene& scene) {
              scene.kinds[0].object = "nothing.modal";
          }).find("nothing.modal") != std::string::npos);
    CHECK(faultOf([](Scene& scene) {
              scene.keyboard->preset = "nothing.json";
          }).find("nothing.json") != std::string::npos);
    CHECK(faultOf([](Scene& scene) { scene.keyboard->preset = "Steel Plate"; }) ==
          "the keyboard's preset 'Steel Plate' has no bars");
}
