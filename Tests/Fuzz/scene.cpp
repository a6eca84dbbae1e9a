// Scenes, as people write them and pass them around.
#include "Fuzz/FuzzTarget.h"
#include "Scene/SceneText.h"

#include <cmath>

namespace idiophone::fuzz {
namespace {

void claimFinite(const Scattered& quantity, const char* what) {
    claim(quantity.mean.allFinite() && quantity.reach.allFinite(), what);
}

void claimKind(const BodyTemplate& kind, std::size_t kindCount) {
    claim(!kind.name.empty() && (kind.ball || !kind.object.empty()),
          "a kind has a name and a body");
    claim(kind.sizeRatio > 0 && kind.friction.value_or(0) >= 0, "its figures are in range");
    claim(kind.restitution.value_or(0) >= 0 && kind.restitution.value_or(0) <= 1,
          "nothing rebounds faster than it came");
    for (const auto passed : kind.passes)
        claim(passed < kindCount, "it passes through kinds that there are");
    if (kind.surface)
        claim(validated(*kind.surface).has_value(), "its surface is valid");
}

} // namespace

void examine(std::string_view bytes) {
    const auto scene = parseScene(bytes, "fuzz.json");
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
}

} // namespace idiophone::fuzz
