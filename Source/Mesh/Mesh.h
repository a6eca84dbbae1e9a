// SPDX-License-Identifier: Apache-2.0
// A triangle mesh and the measures that analysis and queries share. It guarantees no quality:
// meshes from files go through MeshRepair first.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

namespace idiophone {

struct Mesh {
    Eigen::MatrixXd vertices; ///< [N×3] in metres
    Eigen::MatrixXi faces;    ///< [F×3] indices of vertices, counter-clockwise seen from outside

    Eigen::Index vertexCount() const { return vertices.rows(); }
    Eigen::Index faceCount() const { return faces.rows(); }
};

/// An undirected edge a < b and its adjacent faces.
struct MeshEdge {
    int a = 0;
    int b = 0;
    int faceCount = 0;         ///< 1 on a boundary, 2 inside, more if non-manifold
    double adjacentAreaM2 = 0; ///< total area of those faces
};

/// Returns the face's normal, with twice the face's area in m² as its length.
Eigen::RowVector3d doubleAreaVector(const Mesh& mesh, Eigen::Index face);

/// Returns the [F] face areas in m².
Eigen::VectorXd faceAreas(const Mesh& mesh);

/// Returns for each of N vertices a third of the area of its faces, in m²: a_i of Raghuvanshi & Lin
/// 2006, eq. 1.
Eigen::VectorXd vertexAreas(const Mesh& mesh);

/// Returns the [N×3] unit area-weighted vertex normals; (0,0,1) where undefined.
Eigen::MatrixXd vertexNormals(const Mesh& mesh);

/// Returns every edge once, in ascending order of (a, b).
std::vector<MeshEdge> uniqueEdges(const Mesh& mesh);

/// Returns the mean edge length in metres; 0 for a mesh without faces.
double meanEdgeLengthMetres(const Mesh& mesh);

/// Returns true if there are edges and each has exactly two faces.
bool isClosed(const std::vector<MeshEdge>& edges);

/// Returns the vertex nearest to a point. Takes time linear in the number of vertices.
int nearestVertex(const Mesh& mesh, const Eigen::RowVector3d& pointMetres);

/// Returns 0, 1, …, N − 1.
std::vector<int> allVertices(const Mesh& mesh);

/// Returns the bounding box of the vertices that faces use, in metres; empty without faces.
Eigen::AlignedBox3d boxOfFaces(const Mesh& mesh);

/// Returns the diagonal of the bounding box in metres; 0 for a mesh without vertices.
double boundingDiagonalMetres(const Mesh& mesh);

/// Returns the enclosed volume in m³, positive if faces look outward. Meaningful for closed meshes
/// only.
double signedVolumeM3(const Mesh& mesh);

/// The connected components, numbered from 0 in the order of their first vertices. A vertex without
/// a face is a component of its own.
struct Components {
    std::vector<int> componentOfVertex; ///< [N] component number of each vertex
    int count = 0;
};
Components connectedComponents(const Mesh& mesh);

} // namespace idiophone
