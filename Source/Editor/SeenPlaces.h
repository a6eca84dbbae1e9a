// Places of the scene as they are seen in its picture: for what is drawn over it.
#pragma once

#include "Editor/ObjectScene.h"
#include "Editor/OrbitCamera.h"
#include "Editor/PixelProjection.h"

#include <juce_gui_basics/juce_gui_basics.h>
#include <span>
#include <vector>

namespace idiophone {

struct SeenPlace {
    static constexpr float hiddenAlpha = 0.3f; ///< of what is drawn at hidden places

    juce::Point<float> at; ///< in pixels
    bool isHidden = false; ///< behind the scene

    /// Returns the colour, fainter at a hidden place.
    juce::Colour in(juce::Colour colour) const {
        return colour.withMultipliedAlpha(isHidden ? hiddenAlpha : 1.0f);
    }
};

/// Refers to the scene.
class SeenPlaces {
public:
    /// The picture of this camera covers the area.
    SeenPlaces(const ObjectScene& shownScene,
               const OrbitCamera& camera,
               juce::Rectangle<float> area);

    /// Leaves out places nearer than what the camera shows. Those less than `depthMetres` below the
    /// surface are not hidden, as inside the wall of a shell.
    std::vector<SeenPlace> of(std::span<const ScenePlace> places, float depthMetres = 0) const;
    /// The radius in pixels of a ball in the scene, or 0 if the camera does not show it.
    float pixelsOfBall(const ScenePlace& centre, float radiusMetres) const;

private:
    const ObjectScene& scene;
    ScenePlace eye;
    PixelProjection projection;
};

} // namespace idiophone
