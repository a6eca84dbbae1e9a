#include "Editor/VibrationPicture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

constexpr float exaggeration = 0.05f; // fraction of the object's radius, at the largest amplitude
constexpr double modeSwingHz = 1.2;

} // namespace

void VibrationPicture::reset(std::vector<InstrumentView::PlayedObject> newObjects) {
    objects = std::move(newObjects);
    slowMotion.reset();
    surfaces.clear();
    shapeOffsets.reset();
    shownMode.reset();
    watched = 0;
}

void VibrationPicture::follow(std::size_t object, std::span<const ModeNow> modes) {
    if (std::exchange(watched, object) != object)
        slowMotion.reset();
    slowMotion.follow(modes);
}

void VibrationPicture::showMode(std::optional<std::size_t> mode) {
    shownMode = mode;
    shownModePhase = std::numbers::pi / 2;
}

void VibrationPicture::setShown(bool showsVibration, bool showsNodalLines) {
    isShown = showsVibration;
    showsNodes = showsNodalLines;
}

bool VibrationPicture::moves() const {
    return shownMode || (!slowMotion.atRest() && (isShown || showsNodes));
}

void VibrationPicture::advance(double seconds) {
    slowMotion.advance(seconds);
    shownModePhase = std::remainder(shownModePhase + 2 * std::numbers::pi * modeSwingHz * seconds,
                                    2 * std::numbers::pi);
}

std::optional<std::size_t> VibrationPicture::modeWithNodes() const {
    if (shownMode || !showsNodes)
        return shownMode;
    const auto swings = slowMotion.swings();
    const auto strongest = std::ranges::max_element(
        swings, {}, [](const auto& swing) { return std::abs(swing.displacement); });
    return strongest == swings.end() ? 0 : strongest->mode;
}

std::optional<SceneMotion> VibrationPicture::motionIn(const ObjectScene& scene) {
    const auto mode = modeWithNodes();
    if ((!mode && (!isShown || slowMotion.atRest())) || watched >= objects.size())
        return std::nullopt;
    const auto& run = scene.objects()[watched];
    if (run.isBox) // too many faces to animate
        return std::nullopt;
    const auto& surface = surfaces.try_emplace(watched, objects[watched].object).first->second;
    if (mode && *mode >= surface.modeCount())
        return std::nullopt;
    SceneMotion result{.object = watched, .offsets = {}, .scale = exaggeration * run.radius};
    std::vector<float> displacements(objects[watched].object->vertices.size());
    const auto offsets = [&] {
        return std::make_shared<const std::vector<ScenePlace>>(
            scene.offsetsOf(watched, displacements));
    };
    if (!mode) {
        for (const auto& swing : slowMotion.swings())
            surface.add(swing.mode, swing.displacement, displacements);
        result.offsets = offsets();
        return result;
    }
    if (shapeOffsets == nullptr || shapeOf != std::pair(watched, *mode)) {
        surface.add(*mode, 1, displacements);
        shapeOf = {watched, *mode};
        shapeOffsets = offsets();
    }
    result.offsets = shapeOffsets;
    result.scale *= static_cast<float>(std::sin(shownModePhase));
    result.showsNodes = true;
    return result;
}

} // namespace idiophone
