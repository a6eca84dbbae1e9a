#include "Gltf/ObjectFile.h"
#include "Object/ModalObjectFile.h"
#include "Python/Binding.h"

#include <nanobind/stl/filesystem.h>
#include <span>

namespace idiophone::python {
namespace {

/// Returns a view of an array. As a property it keeps its object alive.
template <class Value>
auto view(const Value* data, std::initializer_list<std::size_t> shape) {
    return nb::ndarray<nb::numpy, const Value>(data, shape);
}

/// Returns a new array of one number for each mode.
template <class Number>
auto perMode(const ModalObject& object, Number number) {
    auto* values = new double[object.modeCount()];
    const nb::capsule owner(values,
                            [](void* data) noexcept { delete[] static_cast<double*>(data); });
    for (std::size_t mode = 0; mode < object.modeCount(); ++mode)
        values[mode] = number(mode);
    return nb::ndarray<nb::numpy, double, nb::ndim<1>>(values, {object.modeCount()}, owner);
}

} // namespace

void bindObjects(nb::module_& module) {
    nb::class_<PythonObject>(module, "ModalObject",
                             "The modes of a body: what its shape and material make of its sound. "
                             "M modes, V vertices that carry shapes. It does not change.")
        .def_prop_ro("name", [](const PythonObject& self) { return self.object->name; })
        .def_prop_ro(
            "material", [](const PythonObject& self) { return self.object->material; }, "A copy.")
        .def_prop_ro(
            "method", [](const PythonObject& self) { return self.object->method; },
            "How it was made, such as fem.")
        .def_prop_ro(
            "mass", [](const PythonObject& self) { return self.object->mass.massKg; }, "In kg.")
        .def_prop_ro(
            "thickness", [](const PythonObject& self) { return self.object->thicknessMetres; },
            "Of a shell, in m; 0 for a solid.")
        .def_prop_ro(
            "band", [](const PythonObject& self) { return self.object->bandHz; },
            "Every mode from 20 Hz up to here is present, in Hz.")
        .def_prop_ro(
            "notes", [](const PythonObject& self) { return self.object->provenance.notes; },
            "What repair and analysis chose and why, in sentences.")
        .def_prop_ro(
            "eigenvalues",
            [](const PythonObject& self) {
                return view(self.object->eigenvalues.data(), {self.object->modeCount()});
            },
            "[M] omega^2 in rad^2/s^2, ascending.")
        .def_prop_ro(
            "frequencies",
            [](const PythonObject& self) {
                return perMode(*self.object, [&](std::size_t mode) {
                    return self.object->dampedFrequencyHz(mode);
                });
            },
            nb::rv_policy::automatic, "[M] as they sound, in Hz.")
        .def_prop_ro(
            "decays",
            [](const PythonObject& self) {
                return perMode(*self.object,
                               [&](std::size_t mode) { return self.object->decayPerSecond(mode); });
            },
            nb::rv_policy::automatic, "[M] rates in 1/s: amplitudes fall as exp(-rate t).")
        .def_prop_ro(
            "shapes",
            [](const PythonObject& self) {
                return view(self.object->shapes.data(),
                            {self.object->shapeVertexCount(), self.object->modeCount(), 3});
            },
            "[V,M,3] mass-normalised, in 1/sqrt(kg).")
        .def_prop_ro(
            "shape_vertices",
            [](const PythonObject& self) {
                return view(self.object->shapeVertices.data(), {self.object->shapeVertexCount()});
            },
            "[V] the mesh vertices that carry shapes.")
        .def_prop_ro(
            "vertices",
            [](const PythonObject& self) {
                return view(self.object->vertices.data(), {self.object->vertexCount(), 3});
            },
            "[N,3] of the mesh, in m.")
        .def_prop_ro(
            "faces",
            [](const PythonObject& self) {
                return view(self.object->faces.data(), {self.object->faceCount(), 3});
            },
            "[F,3] vertex numbers.")
        .def(
            "save",
            [](const PythonObject& self, const std::filesystem::path& path) {
                const auto written = writeObject(*self.object, path);
                if (!written)
                    throw nb::value_error(written.error().message.c_str());
            },
            nb::arg("path"), "Writes a .modal file, or a glTF file if the name ends in .glb.")
        .def("__getstate__",
             [](const PythonObject& self) {
                 const auto bytes = encodeModalObject(*self.object);
                 return nb::bytes(bytes.data(), bytes.size());
             })
        .def("__setstate__",
             [](PythonObject& self, const nb::bytes& state) {
                 const std::span bytes(static_cast<const std::byte*>(state.data()), state.size());
                 new (&self)
                     PythonObject(held(valueOf(readModalObject(bytes, "a pickled object"))));
             })
        .def("__repr__", [](const PythonObject& self) {
            return "<ModalObject '" + self.object->name + "' of " +
                   std::to_string(self.object->modeCount()) + " modes>";
        });
    module.def(
        "load", [](const std::filesystem::path& path) { return held(valueOf(readObject(path))); },
        nb::arg("path"),
        "Reads a .modal file, or the first modal model of a glTF file (.gltf, .glb).");
}

} // namespace idiophone::python
