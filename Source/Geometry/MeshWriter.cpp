#include "Geometry/MeshWriter.h"

#include "Geometry/MeshFile.h"
#include "Object/FileBeside.h"
#include "Object/FileBytes.h"

#include <limits>
#include <locale>
#include <ostream>

namespace idiophone {
namespace {

/// Writes each row of a matrix as a line that begins with this word.
Eigen::IOFormat linesOf(const char* word) {
    return {Eigen::StreamPrecision, Eigen::DontAlignCols, " ", "", word, "\n"};
}

/// `figures` may be null.
void writePly(const Mesh& mesh, const VertexFigures* figures, std::ostream& stream) {
    stream << "ply\nformat ascii 1.0\ncomment metres\nelement vertex " << mesh.vertexCount()
           << "\nproperty double x\nproperty double y\nproperty double z\n";
    if (figures != nullptr)
        stream << "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty double "
               << figures->name << '\n';
    stream << "element face " << mesh.faceCount()
           << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (Eigen::Index i = 0; i < mesh.vertexCount(); ++i) {
        stream << mesh.vertices(i, 0) << ' ' << mesh.vertices(i, 1) << ' ' << mesh.vertices(i, 2);
        if (figures != nullptr) {
            const auto vertex = static_cast<std::size_t>(i);
            for (const std::uint8_t part : figures->colours[vertex])
                stream << ' ' << static_cast<int>(part);
            stream << ' ' << figures->values[vertex];
        }
        stream << '\n';
    }
    stream << mesh.faces.format(linesOf("3 "));
}

void writeObj(const Mesh& mesh, std::ostream& stream) {
    stream << mesh.vertices.format(linesOf("v "))
           << (mesh.faces.array() + 1).matrix().format(linesOf("f "));
}

Result<void> replaceByNumbers(const std::filesystem::path& file,
                              const std::function<void(std::ostream&)>& write) {
    const bool isWritten = replaceFile(file, [&](std::ostream& stream) {
        stream.imbue(std::locale::classic());
        stream.precision(std::numeric_limits<double>::max_digits10);
        write(stream);
    });
    if (!isWritten)
        return failure("The mesh file \"" + nameOf(file) + "\" cannot be written.");
    return {};
}

} // namespace

Result<void> writeMesh(const Mesh& mesh, const std::filesystem::path& file) {
    const bool isPly = hasExtension(file, ".ply");
    if (!isPly && !hasExtension(file, ".obj"))
        return failure("The mesh cannot be written to \"" + nameOf(file) +
                       "\": its extension is neither .obj nor .ply.");
    return replaceByNumbers(file, [&](std::ostream& stream) {
        if (isPly)
            writePly(mesh, nullptr, stream);
        else
            writeObj(mesh, stream);
    });
}

Result<void> writeColouredMesh(const Mesh& mesh,
                               const VertexFigures& figures,
                               const std::filesystem::path& file) {
    if (!hasExtension(file, ".ply"))
        return failure("Colours cannot be written to \"" + nameOf(file) +
                       "\": its extension is not .ply.");
    return replaceByNumbers(file, [&](std::ostream& stream) { writePly(mesh, &figures, stream); });
}

} // namespace idiophone
