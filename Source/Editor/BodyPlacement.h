// Places on a stage and on its bodies.
#pragma once

#include "Editor/ObjectScene.h"
#include "Editor/SoundView.h"

#include <array>

namespace idiophone {

/// Column-major, from the object's own coordinates in its size to the stage.
std::array<float, 16> matrixOf(const BodyNow& body);

/// From the stage to the object's own coordinates, as the last one.
ScenePlace turnedBack(const BodyNow& body, const ScenePlace& direction);
ScenePlace onStage(const BodyNow& body, const ScenePlace& own);
ScenePlace onBody(const BodyNow& body, const ScenePlace& place);

} // namespace idiophone
