// Fuzzes scene files: JSON, and glTF in one piece.
#include "Fuzz/FuzzTarget.h"
#include "Instrument/ObjectLibrary.h"
#include "Scene/GltfScene.h"
#include "Scene/SceneSimulation.h"
#include "Scene/SceneText.h"

#include <algorithm>
#include <cmath>

namespace idiophone::fuzz {
namespace {

void claimFinite(const Scattered& quantity, const char* what) {
    claim(quantity.mean.allFinite() && quantity.reach.allFinite(), what);
}

void claimKind(const BodyTemplate& kind, std::size_t kindCount) {
    claim(!kind.name.empty() && (kind.given != nullptr || !kind.object.empty()),
          "a kind has a name and a body");
    claim(kind.sizeRatio > 0 && kind.friction.value_or(0) >= 0, "its figures are in range");
    claim(kind.restitution.value_or(0) >= 0 && kind.restitution.value_or(0) <= 1,
          "nothing rebounds faster than it came");
    for (const auto passed : kind.passes)
        claim(passed < kindCount, "it passes through kinds that there are");
    if (kind.surface)
        claim(validated(*kind.surface).has_value(), "its surface is valid");
}

/// Moves the bodies for a few steps. Uses few kinds of body, a small object, and no surfaces,
/// because a surface becomes a mesh of thousands of faces.
void claimMotion(Scene scene) {
    constexpr std::size_t mostKinds = 3, mostReleases = 4;
    constexpr int mostOfEach = 2;
    static const auto die = ObjectLibrary::shared().find("die").value(); // stays loaded
    if (scene.kinds.size() > mostKinds)
        return;
    for (auto& kind : scene.kinds) {
        kind.object = kind.given != nullptr ? "" : "die";
        if (hasFaces(kind.form))
            kind.form = BodyForm::ground;
    }
    scene.keyboard.reset();
    scene.releases.resize(std::min(scene.releases.size(), mostReleases));
    for (auto& release : scene.releases)
        release.count = std::min(release.count, mostOfEach);
    const auto assets = SceneAssets::make(std::move(scene), ObjectLibrary::shared());
    if (!assets)
        return claimSentence(assets.error());
    SceneSimulation run(*assets, {.notes = {{.note = 60, .velocity = 64}}, .maximumWork = 1000});
    double before = -1;
    for (const double seconds : {0.001, 0.01, 0.1}) {
        run.advanceTo(seconds);
        while (const auto impact = run.takeImpact(seconds)) {
            claim(impact->slot < run.slots().size(), "what has a slot is struck");
            claim(impact->seconds >= before && impact->seconds < seconds,
                  "impacts are in order of time");
            before = impact->seconds;
        }
    }
}

} // namespace

void examine(std::string_view bytes) {
    const auto scene =
        bytes.starts_with("glTF") ? gltfScene(bytes, "fuzz.glb") : parseScene(bytes, "fuzz.json");
    if (!scene)
        return claimSentence(scene.error());
    claim(!scene->name.empty(), "a scene has a name");
    claim(scene->seconds > 0 && scene->stepsPerSecond >= 1000, "time passes");
    for (const auto& kind : scene->kinds)
        claimKind(kind, scene->kinds.size());
    for (const auto& release : scene->releases) {
        claim(release.kind < scene->kinds.size() && release.count >= 1, "bodies are of a kind");
        claimFinite(release.positionMetres, "they are somewhere");
        claimFinite(release.velocityMetresPerSecond, "they move somehow");
    }
    for (const auto& kick : scene->kicks)
        claim(kick.kind < scene->kinds.size() && !scene->kinds[kick.kind].isFixed,
              "what moves is thrown");
    if (scene->noteDrop)
        claim(scene->noteDrop->kind < scene->kinds.size(), "what is dropped is of a kind");
    for (const auto& info : parameterTable())
        claim(scene->parameters[info.parameter] == info.clamped(scene->parameters[info.parameter]),
              "parameters have values that they can take");
    claimMotion(*scene);
}

} // namespace idiophone::fuzz
