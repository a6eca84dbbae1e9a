#include "Geometry/MeshWriter.h"
#include "Geometry/MetricMesh.h"
#include "Python/Binding.h"

#include <nanobind/eigen/dense.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/pair.h>

namespace idiophone::python {
namespace {

using Vertices = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Faces = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

Mesh meshOf(const ArrayLike& givenVertices, const ArrayLike& givenFaces) {
    const auto vertices = arrayOf<Vertices>(givenVertices, "float64", "the vertices are not [N,3]");
    // NumPy would cut fractions off.
    const auto faces = arrayOf<Vertices>(givenFaces, "float64", "the faces are not [F,3]");
    if (!vertices.allFinite())
        throw nb::value_error("a vertex is not finite");
    if (faces.rows() == 0)
        throw nb::value_error("the mesh has no faces");
    if ((faces.array() != faces.array().floor()).any())
        throw nb::value_error("a face has a vertex number with a fraction");
    if (faces.minCoeff() < 0 || faces.maxCoeff() >= static_cast<double>(vertices.rows()))
        throw nb::value_error("a face has a vertex that does not exist");
    return {.vertices = vertices, .faces = faces.cast<int>()};
}

} // namespace

void bindMeshes(nb::module_& module) {
    nb::class_<Mesh>(
        module, "Mesh",
        "A triangle mesh in metres: vertices [N,3], and faces [F,3] of vertex numbers, "
        "counter-clockwise seen from outside.")
        .def(
            "__init__",
            [](Mesh* self, const ArrayLike& vertices, const ArrayLike& faces) {
                new (self) Mesh(meshOf(vertices, faces));
            },
            nb::arg("vertices"), nb::arg("faces"))
        .def_prop_ro(
            "vertices", [](const Mesh& self) { return Vertices(self.vertices); },
            "[N,3] in m, a copy.")
        .def_prop_ro(
            "faces", [](const Mesh& self) { return Faces(self.faces); },
            "[F,3] vertex numbers, a copy.")
        .def(
            "save",
            [](const Mesh& self, const std::filesystem::path& path) {
                if (const auto written = writeMesh(self, path); !written)
                    throw nb::value_error(written.error().message.c_str());
            },
            nb::arg("path"), "Writes an OBJ or PLY file, in m.")
        .def("__getstate__",
             [](const Mesh& self) { return std::pair(Vertices(self.vertices), Faces(self.faces)); })
        .def("__setstate__",
             [](Mesh& self, const std::pair<Vertices, Faces>& state) {
                 new (&self) Mesh{.vertices = state.first, .faces = state.second};
             })
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
