#include "Geometry/MeshWriter.h"
#include "Geometry/MetricMesh.h"
#include "Python/Binding.h"

#include <nanobind/eigen/dense.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

namespace idiophone::python {
namespace {

using Vertices = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Faces = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Returns the [N,3] array that numpy makes of what is given, such as a list.
template <class Matrix>
Matrix matrixOf(const nb::object& given, const char* type, const char* fault) {
    const nb::object array = nb::module_::import_("numpy").attr("ascontiguousarray")(given, type);
    Matrix matrix;
    if (!nb::try_cast(array, matrix))
        throw nb::value_error(fault);
    return matrix;
}

Mesh meshOf(const nb::object& givenVertices, const nb::object& givenFaces) {
    const auto vertices =
        matrixOf<Vertices>(givenVertices, "float64", "the vertices are not [N,3]");
    const auto faces = matrixOf<Faces>(givenFaces, "int32", "the faces are not [F,3]");
    if (!vertices.allFinite())
        throw nb::value_error("a vertex is not finite");
    if (faces.rows() == 0)
        throw nb::value_error("the mesh has no faces");
    if (faces.minCoeff() < 0 || faces.maxCoeff() >= vertices.rows())
        throw nb::value_error("a face has a vertex that does not exist");
    return {.vertices = vertices, .faces = faces};
}

} // namespace

void bindMeshes(nb::module_& module) {
    nb::class_<Mesh>(
        module, "Mesh",
        "A triangle mesh in metres: vertices [N,3], and faces [F,3] of vertex numbers, "
        "counter-clockwise seen from outside.")
        .def(
            "__init__",
            [](Mesh* self, const nb::object& vertices, const nb::object& faces) {
                new (self) Mesh(meshOf(vertices, faces));
            },
            nb::arg("vertices"), nb::arg("faces"))
        .def_prop_ro("vertices", [](const Mesh& self) { return Vertices(self.vertices); })
        .def_prop_ro("faces", [](const Mesh& self) { return Faces(self.faces); })
        .def(
            "save",
            [](const Mesh& self, const std::filesystem::path& path) {
                if (const auto written = writeMesh(self, path); !written)
                    throw nb::value_error(written.error().message.c_str());
            },
            nb::arg("path"), "Writes an OBJ, OFF, PLY or STL file.")
        .def("__repr__", [](const Mesh& self) {
            return "<Mesh of " + std::to_string(self.vertexCount()) + " vertices, " +
                   std::to_string(self.faceCount()) + " faces>";
        });
    module.def(
        "load_mesh",
        [](const std::filesystem::path& path, const std::optional<std::string>& unit) {
            const nb::gil_scoped_release unlocked;
            auto read = readMetricMesh(path, unit);
            const nb::gil_scoped_acquire lock;
            return valueOf(std::move(read)).mesh;
        },
        nb::arg("path"), nb::arg("unit") = nb::none(),
        "Reads an OBJ, OFF, PLY, STL or glTF file (.gltf, .glb).\n\n"
        "`unit` is m, cm, mm, in or ft. None takes metres for glTF, and else guesses it from the "
        "size.");
}

} // namespace idiophone::python
