#include "Geometry/EdgeSplit.h"

#include "Geometry/MeshBuilder.h"

#include <utility>

namespace idiophone {
namespace {

void emit(std::vector<Eigen::RowVector3i>& faces,
          const Eigen::RowVector3i& face,
          const EdgeInsertions& insertions) {
    int edge = 0;
    while (edge < 3 && insertions[edge].empty())
        ++edge;
    if (edge == 3) {
        faces.push_back(face);
        return;
    }
    // Make a fan from the corner opposite the edge. The first and last triangles keep the other two
    // edges and their insertions.
    const int next = (edge + 1) % 3, last = (edge + 2) % 3;
    int from = face(edge);
    for (std::size_t i = 0; i <= insertions[edge].size(); ++i) {
        const bool isFirst = i == 0, isLast = i == insertions[edge].size();
        const int to = isLast ? face(next) : insertions[edge][i];
        emit(faces, {from, to, face(last)},
             {std::vector<int>(), isLast ? insertions[next] : std::vector<int>(),
              isFirst ? insertions[last] : std::vector<int>()});
        from = to;
    }
}

} // namespace

void splitFaces(Mesh& mesh, const std::unordered_map<int, EdgeInsertions>& insertionsOfFace) {
    if (insertionsOfFace.empty())
        return;
    std::vector<Eigen::RowVector3i> faces;
    faces.reserve(static_cast<std::size_t>(mesh.faceCount()) + 2 * insertionsOfFace.size());
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face) {
        const auto found = insertionsOfFace.find(static_cast<int>(face));
        if (found == insertionsOfFace.end())
            faces.emplace_back(mesh.faces.row(face));
        else
            emit(faces, mesh.faces.row(face), found->second);
    }
    mesh.faces = MeshBuilder{{}, std::move(faces)}.mesh().faces;
}

} // namespace idiophone
