// Makes a mesh from a file fit for analysis: welds, drops what is degenerate, joins T-junctions,
// orients, and says in plain words what it did. It does not remesh, and does not close holes: open
// meshes are fine.
#pragma once

#include "Geometry/Mesh.h"
#include "Object/Result.h"

#include <atomic>
#include <string>
#include <vector>

namespace idiophone {

struct RepairSettings {
    double weldTolerance =
        1e-7; ///< vertices this near are one, as a share of the bounding diagonal
    bool largestComponentOnly = false; ///< keep the component with the greatest area alone
    /// Cut the mesh apart where more than two faces meet at an edge, where several fans of faces
    /// meet at a vertex, and where a one-sided surface closes, as remeshing needs it. What was held
    /// together there alone comes apart, so analysis leaves this off.
    bool cutIntoManifold = false;
    const std::atomic<bool>* cancelled = nullptr; ///< as WorkControl's
};

/// What repair found and did; counts of what the mesh holds now come after what was done.
struct RepairReport {
    int weldedVertices = 0;
    int degenerateFaces = 0;      ///< dropped: two corners in one vertex, or no area
    int duplicateFaces = 0;       ///< dropped: the same three vertices as another face
    int joinedVertices = 0;       ///< put into an edge of another face on which they lay
    int unreferencedVertices = 0; ///< dropped: no face (left) names them
    int flippedFaces = 0;         ///< turned to agree with their neighbours, or outward
    int cutVertices = 0;          ///< added so that the mesh became a manifold
    int droppedComponents = 0;
    int components = 0;
    int hollows = 0;          ///< closed surfaces inside another, which bound a hollow in it
    bool isTangled = false;   ///< which closed surface is inside which takes too long to find out
    int boundaryEdges = 0;    ///< 0 when closed
    int nonManifoldEdges = 0; ///< edges of more than two faces
    int oneSidedEdges = 0;    ///< where no turning made neighbours agree

    /// The mesh is open and has more vertices without a face than stray there, or than lost theirs
    /// to repair: the end of its faces may be missing.
    bool mayBeCutOff() const;
    /// Sentences for people, such as "Welded 36 vertices. Open: 40 boundary edges."; may be empty.
    std::string text() const;
};

struct RepairedMesh {
    Mesh mesh;
    RepairReport report;
    std::vector<int> vertexOfInput; ///< for each input vertex its vertex in `mesh`, or −1
};

/// Vertices and faces keep their order, so that a sound mesh comes out as it went in. In the result
/// no face is degenerate or a duplicate, and every vertex has a face. Faces agree across every edge
/// of exactly two faces (but for one-sided ones), and closed surfaces look outward, those inside
/// another into the hollow. A vertex on the edge of a single face, nearer than ten times the weld
/// tolerance (of the diagonal of what has faces), is put into that edge; not in soups of more than
/// 200,000 such edges. With `cutIntoManifold` every edge has one or two faces, which run along it
/// in opposite directions, and the faces at every vertex form one fan. Fails, in one sentence, when
/// indices or values are invalid, no face is left, or the mesh is larger than 10⁹ m or smaller than
/// 10⁻⁹ m, or as WorkControl says once cancelled. n log n for n faces; hollows are looked for a
/// second or two, and none is turned where that does not suffice.
Result<RepairedMesh> repairMesh(const Mesh& mesh, const RepairSettings& settings = {});

} // namespace idiophone
