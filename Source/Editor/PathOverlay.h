// Draws strike paths over the picture: the places that keys strike, and the path that the user
// draws.
#pragma once

#include "Editor/ObjectScene.h"
#include "Editor/OrbitCamera.h"

#include <juce_gui_basics/juce_gui_basics.h>
#include <vector>

namespace idiophone {

class PathOverlay {
public:
    void reset() { *this = {}; }
    /// Takes the places of the objects of this scene.
    void showStruckPlaces(const ProcessorView& view,
                          const std::vector<InstrumentView::PlayedObject>& played,
                          const ObjectScene& scene);

    /// Adds a place to the path that the user draws, if it is on the path's object.
    void drawTo(const ScenePick& pick);
    bool isDrawing() const { return drawnOn.has_value(); }
    /// Sets the drawn path as the object's strike path.
    void finishDrawing(ProcessorView& view);

    /// Covers the component. Parts hidden by the scene are drawn faintly.
    void paint(juce::Graphics& g,
               const juce::Component& component,
               const ObjectScene& scene,
               const OrbitCamera& camera,
               bool showsStruckPlaces) const;

private:
    struct Path {
        std::vector<ScenePlace> places;     ///< ordered from the lowest key's end
        juce::String lowestKey, highestKey; ///< note names for the ends, or empty
    };

    std::vector<Path> paths; ///< one per object
    std::vector<ScenePlace> drawn;
    std::vector<std::array<double, 3>> drawnMetres; ///< `drawn` on the object's own mesh
    std::optional<std::size_t> drawnOn;             ///< index of its object
};

} // namespace idiophone
