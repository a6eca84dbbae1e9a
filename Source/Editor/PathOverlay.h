// Draws strike paths over the picture: the places that keys strike, and the path that the user
// draws.
#pragma once

#include "Editor/ObjectScene.h"
#include "Editor/OrbitCamera.h"

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <vector>

namespace idiophone {

class PathOverlay {
public:
    struct Path {
        std::vector<ScenePlace> places;     ///< ordered from the lowest key's end
        juce::String lowestKey, highestKey; ///< note names for the ends, or empty
    };

    std::vector<Path> paths;       ///< one per object
    std::vector<ScenePlace> drawn; ///< the path that the user draws

    /// Parts hidden by the scene are drawn faintly.
    void paint(juce::Graphics& g,
               juce::Rectangle<float> area,
               const ObjectScene& scene,
               const OrbitCamera& camera,
               juce::Colour colour,
               juce::Colour textColour) const;
};

} // namespace idiophone
