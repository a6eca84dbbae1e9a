#include "Geometry/MeshWriter.h"

#include <fstream>
#include <limits>
#include <locale>

namespace idiophone {

Result<void> writeMesh(const Mesh& mesh, const std::filesystem::path& file) {
    const auto extension = file.extension();
    const bool isPly = extension == ".ply";
    if (!isPly && extension != ".obj")
        return failure("The mesh cannot be written to \"" + file.filename().string() +
                       "\": its extension is neither .obj nor .ply.");
    std::ofstream stream(file, std::ios::binary);
    stream.imbue(std::locale::classic());
    stream.precision(std::numeric_limits<double>::max_digits10);
    if (isPly)
        stream << "ply\nformat ascii 1.0\ncomment metres\nelement vertex " << mesh.vertexCount()
               << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
               << mesh.faceCount() << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (Eigen::Index i = 0; i < mesh.vertexCount(); ++i)
        stream << (isPly ? "" : "v ") << mesh.vertices(i, 0) << ' ' << mesh.vertices(i, 1) << ' '
               << mesh.vertices(i, 2) << '\n';
    const int first = isPly ? 0 : 1;
    for (Eigen::Index i = 0; i < mesh.faceCount(); ++i)
        stream << (isPly ? "3 " : "f ") << mesh.faces(i, 0) + first << ' '
               << mesh.faces(i, 1) + first << ' ' << mesh.faces(i, 2) + first << '\n';
    stream.close();
    if (!stream)
        return failure("The mesh file \"" + file.filename().string() + "\" cannot be written.");
    return {};
}

} // namespace idiophone
