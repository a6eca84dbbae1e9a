#include "Geometry/Subdivision.h"

#include <igl/loop.h>

namespace idiophone {

Mesh subdivided(const Mesh& mesh, int times) {
    Mesh fine = mesh;
    igl::loop(mesh.vertices, mesh.faces, fine.vertices, fine.faces, times);
    return fine;
}

} // namespace idiophone
