// Covers a surface with near-equilateral triangles of a wanted size, as springs and tetrahedra need
// them. For fewer triangles on a scan whatever their shape, see Decimation.
#pragma once

#include "Geometry/Mesh.h"
#include "Object/Result.h"
#include "Object/WorkControl.h"

namespace idiophone {

struct RemeshSettings {
    double edgeLengthMetres = 0; ///< wanted; > 0 and at most half of the bounding diagonal
    /// Edges at which the surface turns by more stay edges, and corners of such edges and of the
    /// boundary stay where they are.
    double sharpAngleDegrees = 40;
    int passes = 5; ///< 1 to 20; of splitting, collapsing, flipping and smoothing
    /// As `remeshedTriangles` counts them; a million take about a gigabyte and half a minute.
    double maximumTriangles = 4e6;
};

/// About how many triangles of an edge length the faces take while they are being remeshed, slivers
/// included: of a long needle many, though its area is small.
double remeshedTriangles(const Mesh& mesh, double edgeLengthMetres);

/// Isotropic remeshing (Botsch & Kobbelt 2004, by CGAL). New vertices lie on the mesh given; its
/// boundary stays in place. Most edges come out between 4/5 and 4/3 of the length wanted; where the
/// shape has sharp edges closer than that, they are shorter.
/// A mesh far denser than wanted is decimated first (Decimation): scans take a fifth of the time,
/// and their noise does not pass for sharp edges. The mesh is repaired first and cut where it is no
/// manifold (MeshRepair), and what hung together there alone comes apart: see
/// RepairReport::nonManifoldEdges before. The result is a manifold, oriented, without degenerate
/// faces, not guaranteed free of self-intersections; the order of vertices and faces is new. Fails,
/// in one sentence, where repair does, for settings outside their ranges, when it would take more
/// than `maximumTriangles`, when ten thousands of
/// faces meet in one vertex, or once cancelled. Never throws. Any thread; not for the audio thread.
Result<Mesh>
remesh(const Mesh& mesh, const RemeshSettings& settings, const WorkControl& control = {});

} // namespace idiophone
