// Makes a mesh from a file fit for analysis: welds, drops what is degenerate, orients, and says in
// plain words what it did. It does not remesh, and does not close holes: open meshes are fine.
#pragma once

#include "Geometry/Mesh.h"
#include "Object/Result.h"

#include <string>
#include <vector>

namespace idiophone {

struct RepairSettings {
    double weldTolerance =
        1e-7; ///< vertices this near are one, as a share of the bounding diagonal
    bool largestComponentOnly = false; ///< keep the component with the greatest area alone
};

/// What repair found and did; counts of what the mesh holds now come after what was done.
struct RepairReport {
    int weldedVertices = 0;
    int degenerateFaces = 0;      ///< dropped: two corners in one vertex, or no area
    int duplicateFaces = 0;       ///< dropped: the same three vertices as another face
    int unreferencedVertices = 0; ///< dropped: no face (left) names them
    int flippedFaces = 0;         ///< turned to agree with their neighbours, or outward
    int droppedComponents = 0;
    int components = 0;
    int boundaryEdges = 0;    ///< 0 when closed
    int nonManifoldEdges = 0; ///< edges of more than two faces

    bool changedAnything() const;
    /// Sentences for people, such as "Welded 36 vertices. Open: 40 boundary edges."; may be empty.
    std::string text() const;
};

struct RepairedMesh {
    Mesh mesh;
    RepairReport report;
    std::vector<int> vertexOfInput; ///< for each input vertex its vertex in `mesh`, or −1
};

/// Vertices and faces keep their order, so that a sound mesh comes out as it went in. Faces are
/// oriented consistently across every edge of exactly two faces, and outward where a surface is
/// closed. Fails, in one sentence, when indices or values are invalid or no face is left.
Result<RepairedMesh> repairMesh(const Mesh& mesh, const RepairSettings& settings = {});

} // namespace idiophone
