// Tests simulations of scenes: songs as falling dice, slots and random numbers.
#include "Scene/SceneSimulation.h"
#include "Instrument/ObjectLibrary.h"
#include "Scene/FactoryScenes.h"
#include "Scene/SceneText.h"

#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <map>
#include <numbers>

using namespace idiophone;
using Catch::Matchers::WithinAbs;

namespace {

std::shared_ptr<const SceneAssets> assetsOf(const Scene& scene) {
    auto assets = SceneAssets::make(scene, ObjectLibrary::shared());
    REQUIRE(assets);
    return *assets;
}

std::shared_ptr<const SceneAssets> factoryAssets(const char* name) {
    const auto* scene = findFactoryScene(name);
    REQUIRE(scene != nullptr);
    return assetsOf(*scene);
}

std::vector<SceneImpact> impactsUntil(SceneSimulation& motion, double seconds) {
    motion.advanceTo(seconds);
    std::vector<SceneImpact> impacts;
    while (const auto impact = motion.takeImpact(seconds))
        impacts.push_back(*impact);
    return impacts;
}

double impulse(const SceneImpact& impact) {
    const auto& i = impact.strike.impulseNewtonSeconds;
    return std::hypot(i[0], i[1], i[2]);
}

} // namespace

TEST_CASE("Every note's die hits its bar within 2 ms of the score") {
    // A scale, repeated notes, a chord, and a note at time 0.
    std::vector<SceneNote> notes;
    for (int k = 0; k < 25; ++k)
        notes.push_back({0.11 * k, 65 + k, 20 + 4 * k});
    for (int k = 0; k < 10; ++k)
        notes.push_back({3.0 + 0.13 * k, 72, 127});
    for (const int note : {72, 76, 79})
        notes.push_back({5, note, 1});
    const auto assets = factoryAssets("Dice on a xylophone");
    SceneSimulation motion(assets, {.notes = notes});
    motion.advanceTo(5.5);
    CHECK_FALSE(motion.finished());
    const auto impacts = impactsUntil(motion, 6.5);
    CHECK(motion.notesLeftOut() == 0);

    for (const auto& note : notes) {
        double nearest = 1;
        for (const auto& impact : impacts) {
            const auto& struck = *assets->roles()[impact.role].kind.model->object;
            if (struck.name == "xylophone-" + std::to_string(note.note))
                nearest = std::min(nearest, std::abs(impact.seconds - note.seconds));
        }
        INFO(note.note << " at " << note.seconds);
        CHECK(nearest < 0.002);
    }
    CHECK(motion.finished());
}

TEST_CASE("A rotating body is heard from the side that faces the listener") {
    const auto assets = factoryAssets("Cylinder off a table");
    const auto listener = assets->scene().listener.positionMetres;
    SceneSimulation motion(assets);
    std::map<std::int32_t, int> sides;
    const auto check = [&](std::size_t slot, const StrikePoint& point) {
        const auto& object = *motion.slots()[slot].object;
        if (object.name != "cylinder") {
            CHECK(point.radiationDirection == -1);
            return;
        }
        REQUIRE(point.radiationDirection >= 0);
        const auto& side =
            object.radiation.directions[static_cast<std::size_t>(point.radiationDirection)];
        const Eigen::Vector3d towards =
            motion.pose(slot)->linear() * Eigen::Vector3d(side[0], side[1], side[2]);
        const Eigen::Vector3d there = (listener - motion.places()[slot]).normalized();
        CHECK(towards.dot(there) > std::cos(33 * std::numbers::pi / 180));
        ++sides[point.radiationDirection];
    };
    for (double seconds = 0; seconds < 3; seconds += 0.001) {
        for (const auto& impact : impactsUntil(motion, seconds))
            check(impact.slot, impact.strike.point);
        for (const auto& touch : motion.touches())
            for (std::size_t end = 0; end < 2; ++end)
                if (touch.forceNewtons > 0 && touch.slots[end] != noSlot)
                    check(touch.slots[end], touch.points[end].point);
    }
    CHECK(sides.size() >= 4);
}

TEST_CASE("A higher velocity makes a die hit its bar harder") {
    const auto assets = factoryAssets("Dice on a xylophone");
    double before = 0;
    for (const int velocity : {1, 32, 64, 96, 127}) {
        SceneSimulation motion(assets, {.notes = {{0.5, 72, velocity}}});
        const auto impacts = impactsUntil(motion, 0.51);
        REQUIRE_FALSE(impacts.empty());
        INFO(velocity);
        CHECK(impulse(impacts.front()) > before);
        before = impulse(impacts.front());
    }
}

TEST_CASE("Kinds of one object share its surface") {
    auto scene = *findFactoryScene("Dice on a xylophone");
    scene.kinds.push_back(scene.kinds.front());
    const auto assets = SceneAssets::make(scene, ObjectLibrary::shared());
    REQUIRE(assets);
    const auto& roles = (*assets)->roles();
    CHECK(roles[0].surface != nullptr);
    CHECK(roles[0].surface == roles[scene.kinds.size() - 1].surface);
    CHECK(roles[0].surface != roles.back().surface); // of a bar
}

TEST_CASE("Notes outside the keyboard are ignored and counted") {
    SceneSimulation motion(factoryAssets("Dice on a xylophone"),
                           {.notes = {{1, 20, 100}, {1, 72, 100}, {2, 126, 9}}});
    CHECK(motion.notesLeftOut() == 2);
}

TEST_CASE("Dice of a long song reuse the slots of removed dice") {
    const auto assets = factoryAssets("Dice on a xylophone");
    const auto standing = SceneSimulation(assets).slots().size();
    const double apart = assets->scene().noteDrop->lifeSeconds + 5;
    std::vector<SceneNote> notes;
    for (int chord = 0; chord < 300; ++chord)
        for (int k = 0; k < 400; ++k)
            notes.push_back({apart * chord, 65 + k % 40, 1 + k % 127});
    CHECK(SceneSimulation(assets, {.notes = notes}).slots().size() == standing + 400);
    // Takes time in proportion to the notes, not to their square.
    for (auto& note : notes)
        note.seconds = 1;
    CHECK(SceneSimulation(assets, {.notes = notes}).slots().size() == standing + notes.size());
}

TEST_CASE("Impacts are in order of time, whatever the intervals of the queries") {
    const auto assets = factoryAssets("Shells in a room");
    SceneSimulation whole(assets), bits(assets);
    const auto expected = impactsUntil(whole, 2);
    std::vector<SceneImpact> found;
    for (double until = 0.00133; until < 2; until += 0.00133)
        for (const auto& impact : impactsUntil(bits, until))
            found.push_back(impact);
    for (const auto& impact : impactsUntil(bits, 2))
        found.push_back(impact);
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

TEST_CASE("Another seed gives other motion") {
    auto scene = *findFactoryScene("Shells in a room");
    SceneSimulation one(assetsOf(scene));
    scene.seed += 1;
    SceneSimulation other(assetsOf(scene));
    const auto first = impactsUntil(one, 1), second = impactsUntil(other, 1);
    REQUIRE_FALSE(first.empty());
    REQUIRE_FALSE(second.empty());
    CHECK(first.front().seconds != second.front().seconds);
}

TEST_CASE("Thrown bodies move again") {
    const auto assets = factoryAssets("Shells in a room");
    const double kick = assets->scene().kicks.front().seconds;
    SceneSimulation motion(assets);
    impactsUntil(motion, kick - 0.5);
    CHECK(impactsUntil(motion, kick).size() < 30);
    CHECK(impactsUntil(motion, kick + 1).size() > 100);
}

TEST_CASE("A missing object or preset of a scene is named in the error") {
    const auto faultOf = [](auto change) {
        auto scene = *findFactoryScene("Dice on a xylophone");
        change(scene);
        const auto assets = SceneAssets::make(scene, ObjectLibrary::shared());
        return assets ? "" : assets.error().message;
    };
    CHECK(faultOf([](Scene& scene) {
              scene.kinds[0].object = "nothing.modal";
          }).find("nothing.modal") != std::string::npos);
    CHECK(faultOf([](Scene& scene) { scene.keyboard->preset = "nothing.json"; }) ==
          "the keyboard's preset nothing.json is neither of the factory's nor a file");
    CHECK(faultOf([](Scene& scene) { scene.keyboard->preset = "Steel Plate"; }) ==
          "the keyboard's preset 'Steel Plate' has no bars");
}

TEST_CASE("A hand taps with (1 + e) times its tool's momentum and rubs at its own speed") {
    auto scene = *findFactoryScene("Bell under a hand");
    const double tool =
        4.0 / 3 * std::numbers::pi * std::pow(0.006, 3) * findMaterial("Steel")->densityKgPerM3;
    scene.kinds[0].restitution = scene.kinds[1].restitution = 0.5;
    scene.hand->taps = {{.seconds = 0, .pointMetres = {0, -0.07, 0.006}, .metresPerSecond = 1},
                        {.seconds = 0.25, .pointMetres = {0, -0.07, 0.006}, .metresPerSecond = 2}};
    scene.hand->path = {{.seconds = 1, .pointMetres = {0, -0.067, 0.006}, .newtons = 3},
                        {.seconds = 2, .pointMetres = {0.03, -0.06, 0.006}, .newtons = 3}};
    SceneSimulation motion(assetsOf(scene));
    const auto impacts = impactsUntil(motion, 1.5);
    REQUIRE(impacts.size() == 2);
    CHECK(impacts[0].seconds == 0);
    CHECK(std::abs(impacts[1].seconds - 0.25) < 1e-9);
    const auto& impulse = impacts[1].strike.impulseNewtonSeconds;
    CHECK(std::abs(std::hypot(impulse[0], impulse[1], impulse[2]) - 1.5 * tool * 2) < 1e-5);
    CHECK(impulse[1] > 0); // +y points into the wall that faces -y
    const auto touching = std::ranges::find_if(
        motion.touches(), [](const TouchState& state) { return state.forceNewtons > 0.1; });
    REQUIRE(touching != motion.touches().end());
    CHECK(std::abs(touching->forceNewtons - 3) < 0.03);
    CHECK(std::abs(touching->slideMetresPerSecond - std::hypot(0.03, 0.007)) < 1e-3);
    motion.advanceTo(3);
    CHECK(std::ranges::all_of(motion.touches(),
                              [](const TouchState& state) { return state.forceNewtons < 1e-6; }));
}

TEST_CASE("A simulation ends when bodies, or their parts, are crowded") {
    // Each of a flat ring's twenty parts is near several parts of another ring in the same place.
    const auto [object, form, count] = GENERATE(table<const char*, BodyForm, int>(
        {{"die", BodyForm::hull, 10000}, {"cylinder", BodyForm::ring, 60}}));
    auto scene = parseScene(R"({"format": "idiophone-scene", "version": 1, "name": "Crowd",
                                "kinds": [{"name": "all", "object": "die"}],
                                "bodies": [{"kind": "all"}]})",
                            "test")
                     .value();
    scene.kinds[0].object = object;
    scene.kinds[0].form = form;
    scene.releases[0].count = count;
    const auto assets = assetsOf(scene);
    SceneSimulation motion(assets);
    CHECK_FALSE(motion.isCrowded());
    motion.advanceTo(5);
    CHECK(motion.isCrowded());
    CHECK(motion.finished());
    CHECK(motion.figures().bodies < 400);
    CHECK(crowdedFault(assets->scene()).message.find("'Crowd'") != std::string::npos);
}

TEST_CASE("A simulation stops at its work limit or when another thread stops it") {
    const auto assets = factoryAssets("Cylinder off a table");
    SceneSimulation little(assets, {.maximumWork = 100});
    little.advanceTo(1);
    CHECK(little.isCutShort());
    CHECK(little.finished());
    CHECK_FALSE(little.takeImpact(1));

    std::atomic<bool> isStopped = false;
    SceneSimulation stopped(assets, {.isStopped = &isStopped});
    CHECK_FALSE(impactsUntil(stopped, 0.5).empty());
    CHECK_FALSE(stopped.finished());
    isStopped = true;
    CHECK(impactsUntil(stopped, 5).empty());
    CHECK(stopped.finished());
}
