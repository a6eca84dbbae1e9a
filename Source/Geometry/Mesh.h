// A triangle mesh and the measures that analysis and queries share. It promises nothing about
// quality: meshes from files go through MeshRepair first.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace idiophone {

struct Mesh {
    Eigen::MatrixXd vertices; ///< [N×3] in metres
    Eigen::MatrixXi faces;    ///< [F×3] indices of vertices, counter-clockwise seen from outside

    Eigen::Index vertexCount() const { return vertices.rows(); }
    Eigen::Index faceCount() const { return faces.rows(); }
};

/// An undirected edge a < b with what lies on its sides.
struct MeshEdge {
    int a = 0;
    int b = 0;
    int faceCount = 0;         ///< 1 on a boundary, 2 inside, more where the mesh is non-manifold
    double adjacentAreaM2 = 0; ///< the summed area of those faces
};

/// [F] areas in m².
Eigen::VectorXd faceAreas(const Mesh& mesh);

/// [N] a third of the area of the faces at each vertex, in m²: a_i of Raghuvanshi & Lin 2006,
/// eq. 1.
Eigen::VectorXd vertexAreas(const Mesh& mesh);

/// [N×3] unit area-weighted vertex normals; (0,0,1) where they are undefined.
Eigen::MatrixXd vertexNormals(const Mesh& mesh);

/// Every edge once, in ascending order of (a, b).
std::vector<MeshEdge> uniqueEdges(const Mesh& mesh);

/// The mean length of the edges in metres; 0 for a mesh without faces.
double meanEdgeLengthMetres(const Mesh& mesh);

/// True when every edge has exactly two faces.
bool isClosed(const std::vector<MeshEdge>& edges);

/// 0, 1, … N − 1.
std::vector<int> allVertices(const Mesh& mesh);

/// The diagonal of the bounding box in metres; 0 for a mesh without vertices.
double boundingDiagonalMetres(const Mesh& mesh);

/// The volume enclosed in m³, positive when the faces look outward; meaningful for a closed mesh.
double signedVolumeM3(const Mesh& mesh);

/// For each vertex the number of the connected component that it belongs to, counted from 0 in
/// order of first vertex. A vertex of no face is a component of its own.
struct Components {
    std::vector<int> componentOfVertex; ///< [N]
    int count = 0;
};
Components connectedComponents(const Mesh& mesh);

} // namespace idiophone
