#include "Fuzz/LatticeMesh.h"

#include <algorithm>

namespace idiophone::fuzz {

Mesh latticeMesh(std::string_view bytes) {
    constexpr std::size_t mostVertices = 64, mostFaces = 200;
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    const auto vertices = 1 + at(0) % mostVertices;
    Mesh mesh{Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(vertices), 3), {}};
    std::size_t next = 1;
    for (std::size_t i = 0; i < vertices * 3 && next < bytes.size(); ++i, ++next)
        // Offsets are below the distance that repair welds, or quarters of a lattice step.
        mesh.vertices(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)) =
            (at(next) & 15) + (at(next) >> 6) * (at(next) & 32 ? 0.25 : 1e-7);
    const auto faces = std::min(mostFaces, (bytes.size() - next) / 3);
    mesh.faces.resize(static_cast<Eigen::Index>(faces), 3);
    for (std::size_t i = 0; i < faces * 3; ++i, ++next)
        mesh.faces(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)) =
            static_cast<int>(at(next) % vertices);
    return mesh;
}

} // namespace idiophone::fuzz
