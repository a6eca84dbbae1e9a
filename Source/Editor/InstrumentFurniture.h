// The furniture of the picture: frames, cords and tubes of keyboards, stands of bells and bowls,
// legs of tables. It cannot be struck. The pips of dice belong to it too.
#pragma once

#include "Editor/FurnitureParts.h"
#include "Editor/ObjectScene.h"
#include "Editor/ProcessorView.h"

#include <span>
#include <utility>
#include <vector>

namespace idiophone {

/// Immutable. The shapes and sizes of the objects decide the furniture.
class InstrumentFurniture {
public:
    /// `played` are the objects of the scene. On a stage, `bodies` are those before the first note.
    InstrumentFurniture(const std::vector<InstrumentView::PlayedObject>& played,
                        const ObjectScene& scene,
                        bool onStage,
                        std::span<const BodyNow> bodies);

    /// Their indices in `parts` begin behind the scene's vertices.
    const std::vector<SceneVertex>& vertices() const { return built.vertices; }
    const std::vector<FurniturePart>& parts() const { return built.parts; }
    /// The head of a mallet with radius 1 around the origin, and its stick along z with radius and
    /// length 1. They are not among `parts`.
    const std::pair<FurniturePart, FurniturePart>& mallet() const { return malletParts; }
    float floorHeight() const { return floor; } ///< z in the scene, in metres

private:
    void addMallet();
    void addForKeyboard(const std::vector<InstrumentView::PlayedObject>& played,
                        const ObjectScene& scene);
    void addForStage(const std::vector<InstrumentView::PlayedObject>& played,
                     const ObjectScene& scene,
                     std::span<const BodyNow> bodies);

    FurnitureParts built;
    std::pair<FurniturePart, FurniturePart> malletParts;
    float floor = 0;
};

} // namespace idiophone
