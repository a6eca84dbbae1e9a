#include "Scene/SceneText.h"

#include "Instrument/ParameterJson.h"
#include "Instrument/SurfaceFile.h"
#include "Object/Material.h"
#include "Object/OneLine.h"
#include "Scene/HandText.h"
#include "Scene/SilentBody.h"

#include <algorithm>
#include <array>

namespace idiophone {
namespace {

// The bounds are generous, as in HandText.h.
constexpr double fastestMetresPerSecond = 100;
constexpr double fastestTurnsPerSecond = 100;
constexpr std::size_t maximumKinds = 24; // SceneAssets uses one bit for each
constexpr std::size_t maximumEntries = 10000;

constexpr std::array<std::pair<std::string_view, BodyForm>, 7> formNames{{
    {"hull", BodyForm::hull},
    {"ring", BodyForm::ring},
    {"sphere", BodyForm::sphere},
    {"cylinder", BodyForm::cylinder},
    {"surface", BodyForm::surface},
    {"ground", BodyForm::ground},
    {"mesh", BodyForm::mesh},
}};

BodyForm parseForm(const JsonPlace& place) {
    const auto name = place.text();
    for (const auto& [known, form] : formNames)
        if (name == known)
            return form;
    place.fail("is " + inQuotes(name) +
               " and none of hull, ring, sphere, cylinder, surface, mesh and ground");
}

std::shared_ptr<const ModalObject> parseBall(const JsonPlace& place) {
    place.allow({"radius", "material"});
    const auto name = place.at("material").text();
    const auto* material = findMaterial(name);
    if (material == nullptr)
        place.at("material").fail("is " + inQuotes(name) + ", which is no material");
    return silentBall(place.at("radius").number(1e-4, 10), *material);
}

BodyTemplate parseKind(const JsonPlace& place) {
    place.allow({"name", "object", "ball", "form", "fixed", "size", "friction", "restitution",
                 "rolling_friction", "contact_radius", "surface", "passes"});
    BodyTemplate kind;
    kind.name = place.at("name").text();
    if (place.has("ball") == place.has("object"))
        place.fail("needs either 'object' or 'ball'");
    read(place, "object", kind.object, &JsonPlace::text);
    read(place, "ball", kind.given, parseBall);
    if (kind.given != nullptr)
        kind.form = BodyForm::sphere;
    read(place, "form", kind.form, parseForm);
    read(place, "fixed", kind.isFixed, &JsonPlace::truth);
    read(place, "size", kind.sizeRatio, &JsonPlace::number, 0.001, 1000);
    read(place, "friction", kind.friction, &JsonPlace::number, 0, 10);
    read(place, "restitution", kind.restitution, &JsonPlace::number, 0, 1);
    read(place, "rolling_friction", kind.rollingFrictionMetres, &JsonPlace::number, 0, 1);
    read(place, "contact_radius", kind.contactRadiusMetres, &JsonPlace::number, 1e-5,
         maximumMetres);
    read(place, "surface", kind.surface, surfaceAt);
    if (!kind.isFixed && (hasFaces(kind.form) || kind.form == BodyForm::ground))
        place.at("form").fail("is for fixed bodies only");
    return kind;
}

Scattered parseScattered(const JsonPlace& place, const char* key, double reach) {
    Scattered quantity;
    read(place, key, quantity.mean, &JsonPlace::vector, reach);
    const std::string scatter = std::string(key) + "_scatter";
    if (place.has(scatter.c_str()))
        quantity.reach = place.at(scatter.c_str()).vector(reach).cwiseAbs();
    return quantity;
}

Release parseRelease(const JsonPlace& place, const std::vector<BodyTemplate>& kinds) {
    place.allow({"kind", "count", "time", "over", "at", "at_scatter", "turned", "turned_scatter",
                 "turned_at_random", "velocity", "velocity_scatter", "spin", "spin_scatter"});
    Release release;
    release.kind = parseKindName(place.at("kind"), kinds);
    read(place, "count", release.count, &JsonPlace::integer, 1, maximumSceneBodies);
    read(place, "time", release.seconds, &JsonPlace::number, 0, longestSeconds);
    read(place, "over", release.overSeconds, &JsonPlace::number, 0, longestSeconds);
    release.positionMetres = parseScattered(place, "at", maximumMetres);
    release.turnedDegrees = parseScattered(place, "turned", 360);
    read(place, "turned_at_random", release.isTurnedAtRandom, &JsonPlace::truth);
    release.velocityMetresPerSecond = parseScattered(place, "velocity", fastestMetresPerSecond);
    release.spinTurnsPerSecond = parseScattered(place, "spin", fastestTurnsPerSecond);
    return release;
}

Kick parseKick(const JsonPlace& place, const std::vector<BodyTemplate>& kinds) {
    place.allow({"kind", "time", "velocity", "velocity_scatter", "spin", "spin_scatter"});
    Kick kick;
    kick.kind = parseKindName(place.at("kind"), kinds);
    if (kinds[kick.kind].isFixed)
        place.at("kind").fail("is fixed and cannot be thrown");
    kick.seconds = place.at("time").number(0, longestSeconds);
    kick.velocityMetresPerSecond = parseScattered(place, "velocity", fastestMetresPerSecond);
    kick.spinTurnsPerSecond = parseScattered(place, "spin", fastestTurnsPerSecond);
    return kick;
}

KeyboardStage parseKeyboard(const JsonPlace& place) {
    place.allow({"preset", "spacing", "at"});
    KeyboardStage stage;
    stage.preset = place.at("preset").text();
    read(place, "spacing", stage.spacingMetres, &JsonPlace::number, 0.001, 10);
    read(place, "at", stage.positionMetres, &JsonPlace::vector, maximumMetres);
    return stage;
}

/// Parses a pair of values: for the softest and the hardest note.
std::array<double, 2> parseSpan(const JsonPlace& place, double lowest, double highest) {
    const auto ends = place.list(2);
    if (ends.size() != 2)
        place.fail("is not a list of two numbers, for the softest and the hardest note");
    return {ends[0].number(lowest, highest), ends[1].number(lowest, highest)};
}

KeyThrow parseKeyThrow(const JsonPlace& place) {
    place.allow({"raise", "speed"});
    KeyThrow keys;
    read(place, "raise", keys.raisedMetres, parseSpan, 0, 100);
    read(place, "speed", keys.speedRatios, parseSpan, 0, 100);
    return keys;
}

NoteDrop parseNoteDrop(const JsonPlace& place, const std::vector<BodyTemplate>& kinds) {
    place.allow({"kind", "heights", "scatter", "life", "at"});
    NoteDrop drop;
    drop.kind = parseKindName(place.at("kind"), kinds);
    if (kinds[drop.kind].isFixed)
        place.at("kind").fail("is fixed and cannot be dropped");
    if (place.has("heights")) {
        const auto heights = parseSpan(place.at("heights"), 0.001, 100);
        drop.softestMetres = heights[0];
        drop.hardestMetres = heights[1];
    }
    if (place.has("scatter"))
        drop.reachMetres = place.at("scatter").vector(10).cwiseAbs().head<2>();
    read(place, "life", drop.lifeSeconds, &JsonPlace::number, 0.01, 60);
    read(place, "at", drop.positionMetres, &JsonPlace::vector, maximumMetres);
    return drop;
}

Listener parseListener(const JsonPlace& place) {
    place.allow({"at", "towards"});
    Listener listener;
    read(place, "at", listener.positionMetres, &JsonPlace::vector, maximumMetres);
    read(place, "towards", listener.towardsMetres, &JsonPlace::vector, maximumMetres);
    if ((listener.towardsMetres - listener.positionMetres).norm() < 1e-6)
        place.fail("is at the place it looks towards");
    return listener;
}

ParameterValues parseParameters(const JsonPlace& place) {
    ParameterValues values;
    if (const auto unknown = readParameters(place, values); !unknown.empty())
        place.fail("has no " + inQuotes(unknown.front()));
    return values;
}

void parseTimes(const JsonPlace& root, Scene& scene) {
    read(root, "seconds", scene.seconds, &JsonPlace::number, 0.001, longestSeconds);
    read(root, "seed", scene.seed, &JsonPlace::integer, 0, 1'000'000'000);
    read(root, "steps_per_second", scene.stepsPerSecond, &JsonPlace::number, 1000, 20000);
    read(root, "gravity", scene.gravityMetresPerSecond2, &JsonPlace::number, 0, 100);
}

void parseKinds(const JsonPlace& root, Scene& scene) {
    const auto places = root.at("kinds").list(maximumKinds);
    for (const auto& place : places) {
        scene.kinds.push_back(parseKind(place));
        const auto& name = scene.kinds.back().name;
        if (std::ranges::count(scene.kinds, name, &BodyTemplate::name) > 1)
            place.at("name").fail("is " + inQuotes(name) + " like that of another kind");
    }
    // A second pass, because a kind may be named before it is described.
    for (std::size_t k = 0; k < places.size(); ++k)
        if (places[k].has("passes"))
            for (const auto& name : places[k].at("passes").list(maximumKinds))
                scene.kinds[k].passes.push_back(parseKindName(name, scene.kinds));
}

Scene parse(const JsonPlace& root) {
    root.expectFormat("scene", sceneFormatVersion);
    root.allow({"format", "version", "name", "description", "seconds", "seed", "steps_per_second",
                "gravity", "kinds", "bodies", "kicks", "keyboard", "notes", "keys", "hand",
                "listener", "parameters"});
    Scene scene;
    scene.name = root.at("name").text();
    read(root, "description", scene.description, &JsonPlace::text);
    parseTimes(root, scene);
    if (root.has("kinds"))
        parseKinds(root, scene);
    if (root.has("bodies"))
        for (const auto& place : root.at("bodies").list(maximumEntries))
            scene.releases.push_back(parseRelease(place, scene.kinds));
    int count = 0;
    for (const auto& release : scene.releases)
        count += release.count;
    if (count > maximumSceneBodies)
        root.at("bodies").fail("are more than " + std::to_string(maximumSceneBodies));
    if (root.has("kicks"))
        for (const auto& place : root.at("kicks").list(maximumEntries))
            scene.kicks.push_back(parseKick(place, scene.kinds));
    read(root, "keyboard", scene.keyboard, parseKeyboard);
    read(root, "notes", scene.noteDrop, parseNoteDrop, scene.kinds);
    read(root, "keys", scene.keyThrow, parseKeyThrow);
    read(root, "hand", scene.hand, parseHand, scene.kinds);
    read(root, "listener", scene.listener, parseListener);
    read(root, "parameters", scene.parameters, parseParameters);
    if (scene.releases.empty() && !scene.noteDrop)
        root.fail("has nothing that moves: neither 'bodies' nor 'notes'");
    const auto isPlayed = [&](const Release& release) { return release.kind == scene.hand->kind; };
    if (scene.hand && std::ranges::none_of(scene.releases, isPlayed))
        root.at("hand").at("kind").fail("is of none of the bodies");
    return scene;
}

} // namespace

Result<Scene> parseScene(std::string_view text, std::string_view file) {
    if (text.size() > largestSceneBytes)
        return failure(std::string(file) + ": it is too large for a scene");
    return parsedJson(text, file, parse);
}

} // namespace idiophone
