// Prepares a mesh from a file for analysis: welds vertices, drops degenerate faces, joins
// T-junctions, orients, and reports what it did. It does not remesh or close holes; open meshes are
// allowed.
#pragma once

#include "Mesh/Mesh.h"
#include "Object/Result.h"

#include <atomic>
#include <string>
#include <vector>

namespace idiophone {

struct RepairSettings {
    double weldTolerance =
        1e-7; ///< vertices closer than this become one; fraction of the faces' bounding diagonal
    bool largestComponentOnly = false; ///< keep only the component with the largest area
    /// Cut the mesh where more than two faces meet at an edge, where several fans meet at a vertex,
    /// and where a one-sided surface closes, because remeshing needs a manifold. Parts connected
    /// only at such places separate, so analysis leaves this setting off.
    bool cutIntoManifold = false;
    const std::atomic<bool>* cancelled = nullptr; ///< see WorkControl
};

/// Repair's actions, then counts for the resulting mesh.
struct RepairReport {
    int weldedVertices = 0;
    int degenerateFaces = 0;      ///< dropped: two corners in one vertex, or no area
    int duplicateFaces = 0;       ///< dropped: the same three vertices as another face
    int joinedVertices = 0;       ///< inserted into the edge of another face
    int unreferencedVertices = 0; ///< dropped: no remaining face uses them
    int flippedFaces = 0;         ///< turned over to agree with neighbours or to look outward
    int cutVertices = 0;          ///< added to make the mesh a manifold
    int droppedComponents = 0;
    int components = 0;
    int hollows = 0;          ///< closed surfaces inside another, which bound hollows
    bool isTangled = false;   ///< the search for hollows took too long
    int boundaryEdges = 0;    ///< 0 when closed
    int nonManifoldEdges = 0; ///< edges of more than two faces
    int oneSidedEdges = 0;    ///< edges whose faces cannot agree on a side

    /// Returns true if the end of the mesh may be missing: it is open, and it had too many vertices
    /// without a face to be explained by stray vertices or dropped faces.
    bool mayBeCutOff() const;
    /// Returns sentences for the user, such as "Joined 36 points that lay on
    /// others. The surface is open along 40 edges."; may
    /// be empty.
    std::string text() const;
};

struct RepairedMesh {
    Mesh mesh;
    RepairReport report;
    std::vector<int> vertexOfInput; ///< vertex of `mesh` for each input vertex, or −1
};

/// Repairs a mesh. Vertices and faces keep their order, so that a good mesh stays unchanged. In the
/// result, no face is degenerate or a duplicate, and every vertex has a face. Faces agree across
/// every edge of exactly two faces, except one-sided ones. Closed surfaces look outward; those
/// inside another look into the hollow.
/// A vertex near the edge of a single face is inserted into that edge (skipped if there are more
/// than 200,000 such edges). "Near" is ten weld tolerances, as fractions of the remaining mesh's
/// diagonal.
/// With `cutIntoManifold`, every edge has one or two faces, which run along it in opposite
/// directions, and the faces at every vertex form one fan.
/// Fails with one sentence if indices or values are invalid, no face is left, the mesh is larger
/// than 10⁹ m or smaller than 10⁻⁹ m, or if cancelled (WorkControl). Takes O(n log n) time for n
/// faces. The search for hollows stops after a second or two and then turns none.
Result<RepairedMesh> repairMesh(const Mesh& mesh, const RepairSettings& settings = {});

} // namespace idiophone
