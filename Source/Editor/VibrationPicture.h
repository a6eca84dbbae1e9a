// The vibration that the picture shows: the sounding modes in slow motion, or one mode's shape.
#pragma once

#include "Editor/PictureRenderer.h"
#include "Editor/ProcessorView.h"
#include "Editor/SlowMotion.h"
#include "Editor/SurfaceMotion.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace idiophone {

/// For the message thread.
class VibrationPicture {
public:
    /// Takes the objects of a scene, at rest.
    void reset(std::vector<InstrumentView::PlayedObject> newObjects) {
        objects = std::move(newObjects);
        slowMotion.reset();
        surfaces.clear();
        shapeOffsets.reset();
        shownMode.reset();
        watched = 0;
    }
    /// Takes the current modes of an object.
    void follow(std::size_t object, std::span<const ModeNow> modes) {
        if (std::exchange(watched, object) != object)
            slowMotion.reset();
        slowMotion.follow(modes);
    }
    /// Shows the shape of one mode of the followed object, or none.
    void showMode(std::optional<std::size_t> mode) {
        shownMode = mode;
        shownModePhase = std::numbers::pi / 2;
    }
    void setShown(bool showsVibration, bool showsNodalLines) {
        isShown = showsVibration;
        showsNodes = showsNodalLines;
    }

    bool moves() const { return shownMode || (!slowMotion.atRest() && (isShown || showsNodes)); }
    void advance(double seconds) {
        slowMotion.advance(seconds);
        shownModePhase = std::remainder(
            shownModePhase + 2 * std::numbers::pi * modeSwingHz * seconds, 2 * std::numbers::pi);
    }
    /// The displacement in the scene of these objects; nothing at rest.
    std::optional<SceneMotion> motionIn(const ObjectScene& scene) {
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

private:
    /// Fraction of the object's radius, at the largest amplitude.
    static constexpr float exaggeration = 0.05f;
    static constexpr double modeSwingHz = 1.2;

    std::optional<std::size_t> modeWithNodes() const {
        if (shownMode || !showsNodes)
            return shownMode;
        const auto swings = slowMotion.swings();
        const auto strongest = std::ranges::max_element(
            swings, {}, [](const auto& swing) { return std::abs(swing.displacement); });
        return strongest == swings.end() ? 0 : strongest->mode;
    }

    std::vector<InstrumentView::PlayedObject> objects;
    SlowMotion slowMotion;
    std::size_t watched = 0; ///< index of the object in `slowMotion`
    std::map<std::size_t, SurfaceMotion> surfaces;
    std::optional<std::size_t> shownMode;
    double shownModePhase = 0; ///< radians
    std::shared_ptr<const std::vector<ScenePlace>> shapeOffsets;
    std::pair<std::size_t, std::size_t> shapeOf{}; ///< object and mode of `shapeOffsets`
    bool isShown = true, showsNodes = false;
};

} // namespace idiophone
