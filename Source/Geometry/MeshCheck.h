// What a mesh is fit for: closed or open, free of self-intersections, chunky or thin. Analysis
// chooses between tetrahedra and shells by it. It judges, and changes nothing.
#pragma once

#include "Geometry/Mesh.h"

#include <atomic>
#include <optional>

namespace idiophone {

/// 2 V / A: of a plate or a wall its thickness, of a ball 2/3 of its radius, of a long rod its
/// radius; 0 of what has no area.
inline double wallThicknessMetres(double areaM2, double volumeM3) {
    return areaM2 > 0 ? 2 * volumeM3 / areaM2 : 0;
}

struct MeshCheck {
    int boundaryEdges = 0;    ///< edges of one face
    int nonManifoldEdges = 0; ///< edges of more than two faces
    bool isClosed = false;    ///< every edge has exactly two faces
    bool isOriented = false;  ///< closed, and the faces agree across every edge
    /// See SelfIntersection.h; nothing where it could not be found out in bounded time.
    std::optional<bool> intersectsItself;
    double areaM2 = 0;
    double volumeM3 = 0; ///< enclosed, hollows taken off; 0 where not closed and oriented
    double meanThicknessMetres = 0; ///< see wallThicknessMetres; 0 where the volume is
    /// √A / meanThickness: how many mean thicknesses the surface is wide. A ball has 5.3, a cube
    /// 7.3, a ring of radius 10 times that of its section 20; infinite where there is no volume.
    double slenderness = 0;

    /// A surface that encloses a volume which tetrahedra can fill.
    bool isSolid() const {
        return isClosed && isOriented && intersectsItself == false && volumeM3 > 0;
    }
    /// Thin as a shell is, or no solid at all. Tetrahedra about as large as the wall is thick
    /// number several times slenderness²: beyond `thinSlenderness` some ten thousand, while a plate
    /// whose side is fifty times its thickness (slenderness 75), or thinner, bends as a shell does.
    bool isThin() const { return !(slenderness <= thinSlenderness); }
    static constexpr double thinSlenderness = 70;
};

/// The mesh is as repairMesh leaves it: oriented, indices valid. `cancelled` ends the search for
/// self-intersections, the only long part, without a verdict.
MeshCheck checkMesh(const Mesh& mesh, const std::atomic<bool>* cancelled = nullptr);

} // namespace idiophone
