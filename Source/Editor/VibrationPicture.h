// The vibration that the picture shows: the sounding modes in slow motion, or one mode's shape.
#pragma once

#include "Editor/PictureRenderer.h"
#include "Editor/ProcessorView.h"
#include "Editor/SlowMotion.h"
#include "Editor/SurfaceMotion.h"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace idiophone {

/// For the message thread.
class VibrationPicture {
public:
    /// Takes the objects of a scene, at rest.
    void reset(std::vector<InstrumentView::PlayedObject> newObjects);
    /// Takes the current modes of an object.
    void follow(std::size_t object, std::span<const ModeNow> modes);
    /// Shows the shape of one mode of the followed object, or none.
    void showMode(std::optional<std::size_t> mode);
    void setShown(bool showsVibration, bool showsNodalLines);

    bool moves() const;
    void advance(double seconds);
    /// Returns the displacement of the scene's objects, or nothing at rest.
    std::optional<SceneMotion> motionIn(const ObjectScene& scene);

private:
    std::optional<std::size_t> modeWithNodes() const;

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
