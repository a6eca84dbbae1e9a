// A range of the picture's vertices, and its extent.
#pragma once

#include "Editor/DrawingMesh.h"
#include "Editor/SceneVertex.h"

#include <cstddef>

namespace idiophone {

/// A range of vertices, three per face.
struct SceneObject {
    std::size_t firstVertex = 0;
    std::size_t vertexCount = 0;
    Form form = Form::free;
    bool isClosed = false;             ///< its inside is never seen
    ScenePlace middle{}, halfExtent{}; ///< of its bounding box, in metres
    float radius = 0;                  ///< half the diagonal of its box, in metres
    bool isBox = false;                ///< drawn as a box, because the face limit is reached
};

} // namespace idiophone
