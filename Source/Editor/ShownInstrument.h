// The instrument that the picture shows: its objects, their scene and its furniture.
#pragma once

#include "Editor/InstrumentFurniture.h"
#include "Editor/ObjectScene.h"
#include "Editor/OrbitCamera.h"
#include "Editor/ProcessorView.h"
#include "Editor/SceneFrame.h"

#include <memory>
#include <optional>
#include <vector>

namespace idiophone {

/// For the message thread. `scene` and `furniture` are never nullptr.
struct ShownInstrument {
    std::vector<InstrumentView::PlayedObject> played;
    std::shared_ptr<const ObjectScene> scene;
    std::shared_ptr<const InstrumentFurniture> furniture;
    bool onStage = false;
    std::vector<BodyNow> bodies;       ///< on a stage: bodies as drawn
    std::vector<BodyNow> formerBodies; ///< one frame of the sound before

    /// The current instrument. If there is too little memory for its picture, there are no objects.
    static ShownInstrument of(const ProcessorView& view);

    /// Returns the places that the camera frames: of objects or bodies, of a single object's stand,
    /// and of a keyboard's frame from its bars upwards.
    std::vector<ScenePlace> outline() const;
    std::optional<ScenePick> pick(const ViewRay& ray) const;
    /// Takes the bodies of the next frame. Returns whether one has moved, come or gone.
    bool follow(const std::vector<BodyNow>& next);
    /// Whether a body has not moved since the former frame.
    bool rests(const BodyNow& body) const;
    /// The bodies to draw; nothing if objects stand as laid out.
    std::optional<std::vector<SceneBody>> drawnBodies() const;
};

} // namespace idiophone
