// The strike path drawn over the instrument's picture: the places that keys strike, and a path that
// is being drawn by hand.
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
        std::vector<ScenePlace> places;     ///< from the lowest key's end on
        juce::String lowestKey, highestKey; ///< names for its ends, or empty
    };

    std::vector<Path> paths;       ///< one an object
    std::vector<ScenePlace> drawn; ///< by hand

    /// What the scene hides is drawn faintly.
    void paint(juce::Graphics& g,
               juce::Rectangle<float> area,
               const ObjectScene& scene,
               const OrbitCamera& camera,
               juce::Colour colour,
               juce::Colour textColour) const;
};

} // namespace idiophone
