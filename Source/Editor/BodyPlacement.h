// Conversions between stage coordinates and the coordinates of each body.
#pragma once

#include "Editor/ObjectScene.h"
#include "Editor/SoundView.h"

#include <array>

namespace idiophone {

/// The pose as a column-major 4 x 4 matrix: from the object's coordinates, scaled to its size, to
/// the stage.
std::array<float, 16> matrixOf(const BodyNow& body);

/// Rotates a direction from the stage into the object's coordinates.
ScenePlace turnedBack(const BodyNow& body, const ScenePlace& direction);
/// Converts a position from the object's coordinates to the stage.
ScenePlace onStage(const BodyNow& body, const ScenePlace& own);
/// Converts a position from the stage to the object's coordinates.
ScenePlace onBody(const BodyNow& body, const ScenePlace& place);

} // namespace idiophone
