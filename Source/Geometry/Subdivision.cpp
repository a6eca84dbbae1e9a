#include "Geometry/Subdivision.h"

#include <igl/is_edge_manifold.h>
#include <igl/loop.h>
#include <igl/remove_unreferenced.h>

namespace idiophone {

Mesh subdivided(const Mesh& mesh, int times) {
    if (!igl::is_edge_manifold(mesh.faces))
        return mesh;
    Mesh used; // libigl reads beyond its lists where a vertex has no face
    Eigen::VectorXi newNumbers;
    igl::remove_unreferenced(mesh.vertices, mesh.faces, used.vertices, used.faces, newNumbers);
    Mesh fine;
    igl::loop(used.vertices, used.faces, fine.vertices, fine.faces, times);
    return fine;
}

} // namespace idiophone
