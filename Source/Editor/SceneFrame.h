// All that one drawing of the picture shows.
#pragma once

#include "Editor/Appearance.h"
#include "Editor/InstrumentFurniture.h"
#include "Editor/ObjectScene.h"

#include <array>
#include <cstddef>
#include <juce_graphics/juce_graphics.h>
#include <memory>
#include <optional>
#include <vector>

namespace idiophone {

/// The displacement of one object of the scene.
struct SceneMotion {
    std::size_t object = 0;
    /// Offset of each scene vertex of the object. New offsets need a new pointer.
    std::shared_ptr<const std::vector<ScenePlace>> offsets;
    float scale = 1;
    /// Colours outward and inward motion differently, and draws nodal lines between them. The
    /// offsets must then have a maximum of 1.
    bool showsNodes = false;
};

/// One body on a stage: an object and its pose. Several bodies may share an object.
struct SceneBody {
    std::size_t object = 0;
    std::array<float, 16> pose{}; ///< column-major
};

/// The light of a sounding object, which spreads from the struck place.
struct ObjectGlow {
    ScenePlace place{};
    float metres = 1;     ///< radius of the light
    float brightness = 0; ///< 0 to 1

    bool operator==(const ObjectGlow&) const = default;
};

/// A mallet at the moment.
struct DrawnMallet {
    ScenePlace head{};     ///< middle of the head
    ScenePlace stick{};    ///< unit direction from the head to the hand
    float headMetres = 0;  ///< radius
    float stickMetres = 0; ///< length

    bool operator==(const DrawnMallet&) const = default;
};

struct SceneFrame {
    std::shared_ptr<const ObjectScene> scene;
    std::shared_ptr<const InstrumentFurniture> furniture; ///< of the scene
    std::vector<Appearance> appearances;                  ///< of each object
    std::array<float, 16> viewProjection{};               ///< column-major
    ScenePlace eye{};
    juce::Colour background, accent;
    bool isDark = true;                 ///< the look
    std::vector<ObjectGlow> glows = {}; ///< of each object; or empty
    std::vector<DrawnMallet> mallets = {};
    Appearance malletHead = {};
    float discRadians = 0; ///< turn of the discs in tubes
    std::optional<SceneMotion> motion;
    std::optional<std::vector<SceneBody>> bodies; ///< if set, drawn instead of the objects
};

} // namespace idiophone
