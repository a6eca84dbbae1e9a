// Judges a mesh: closed or open, self-intersecting or not, thick or thin. Analysis uses the result
// to choose between tetrahedra and shells. The mesh does not change.
#pragma once

#include "Mesh/Mesh.h"

#include <atomic>
#include <optional>

namespace idiophone {

/// Returns 2 V / A: the thickness of a plate or wall, 2/3 of the radius of a ball, the radius of a
/// long rod. Returns 0 if there is no area.
inline double wallThicknessMetres(double areaM2, double volumeM3) {
    return areaM2 > 0 ? 2 * volumeM3 / areaM2 : 0;
}

struct MeshCheck {
    int boundaryEdges = 0;    ///< edges of one face
    int nonManifoldEdges = 0; ///< edges of more than two faces
    bool isClosed = false;    ///< every edge has exactly two faces
    bool isOriented = false;  ///< closed, and faces agree across every edge
    /// see SelfIntersection.h; empty if the search took too long or was cancelled
    std::optional<bool> intersectsItself;
    double areaM2 = 0;
    double volumeM3 = 0;            ///< enclosed, without hollows; 0 unless closed and oriented
    double meanThicknessMetres = 0; ///< see wallThicknessMetres; 0 if the volume is 0
    /// √A / meanThickness: the width of the surface in mean thicknesses. It is 5.3 for a ball, 7.3
    /// for a cube, and 20 for a torus whose radius is 10 times its section's. Infinite without a
    /// volume.
    double slenderness = 0;

    /// Returns true if the surface encloses a volume that tetrahedra can fill.
    bool isSolid() const {
        return isClosed && isOriented && intersectsItself == false && volumeM3 > 0;
    }
    /// Returns true if the mesh is thin like a shell or has no volume. Tetrahedra as large as the
    /// wall is thick number several times slenderness²: some ten thousand at `thinSlenderness`. A
    /// plate whose side is at least fifty times its thickness (slenderness 75) bends like a shell.
    bool isThin() const { return !(slenderness <= thinSlenderness); }
    static constexpr double thinSlenderness = 70;
};

/// Checks a mesh that repairMesh has oriented, with valid indices. `cancelled` ends the search for
/// self-intersections, the only long part, without a result.
MeshCheck checkMesh(const Mesh& mesh, const std::atomic<bool>* cancelled = nullptr);

} // namespace idiophone
