// Where a body on a stage is, as rotation and translation of places.
#pragma once

#include "Editor/ObjectScene.h"
#include "Editor/SoundView.h"

#include <array>

namespace idiophone {

/// Column-major, from the object's own coordinates in its size to the stage.
std::array<float, 16> matrixOf(const BodyNow& body);

ScenePlace turned(const BodyNow& body, const ScenePlace& direction);
ScenePlace turnedBack(const BodyNow& body, const ScenePlace& direction);
ScenePlace onStage(const BodyNow& body, const ScenePlace& own);
ScenePlace onBody(const BodyNow& body, const ScenePlace& place);

} // namespace idiophone
