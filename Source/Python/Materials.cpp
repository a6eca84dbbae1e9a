#include "Object/MaterialFile.h"
#include "Python/Binding.h"

#include <fstream>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

namespace idiophone::python {
namespace {

Material named(const std::string& name) {
    if (const auto* material = findMaterial(name))
        return *material;
    throw nb::value_error(("there is no material '" + name + "'").c_str());
}

} // namespace

void bindMaterials(nb::module_& module) {
    nb::class_<Material>(module, "Material",
                         "What a body is made of. ``Material(\"Glass\")`` is one of the library; "
                         "its figures may be changed.")
        .def(
            "__init__",
            [](Material* self, const std::string& name) { new (self) Material(named(name)); },
            nb::arg("name"))
        .def_rw("name", &Material::name)
        .def_rw("youngs_modulus", &Material::youngsModulusPa, "In Pa; for wood along the grain.")
        .def_rw("density", &Material::densityKgPerM3, "In kg/m3.")
        .def_rw("poisson_ratio", &Material::poissonRatio)
        .def_prop_rw(
            "damping_fluid", [](const Material& self) { return self.damping.fluidPerSecond; },
            [](Material& self, double value) { self.damping.fluidPerSecond = value; },
            "Gamma in 1/s: amplitudes fall at the rate (gamma + chi omega + eta omega^2) / 2.")
        .def_prop_rw(
            "damping_viscoelastic",
            [](const Material& self) { return self.damping.viscoelasticSeconds; },
            [](Material& self, double value) { self.damping.viscoelasticSeconds = value; },
            "Eta in s.")
        .def_prop_rw(
            "loss_factor", [](const Material& self) { return self.damping.lossFactor; },
            [](Material& self, double value) { self.damping.lossFactor = value; }, "Chi.")
        .def_rw("friction", &Material::friction)
        .def_rw("restitution", &Material::restitution)
        .def_rw("roughness", &Material::roughness)
        .def_rw("source", &Material::source, "Where the figures come from.")
        .def(
            "save",
            [](const Material& self, const std::filesystem::path& path) {
                std::ofstream file(path, std::ios::binary);
                if (!(file << encodeMaterial(valueOf(validated(self))) << std::flush))
                    throw nb::value_error((path.string() + " cannot be written").c_str());
            },
            nb::arg("path"), "Writes a JSON file that the console and the window read.")
        .def("__repr__", [](const Material& self) { return "Material('" + self.name + "')"; });
    module.def(
        "materials",
        [] {
            std::vector<std::string> names;
            for (const auto& material : materialLibrary())
                names.push_back(material.name);
            return names;
        },
        "The names of the library's materials.");
    module.def(
        "load_material",
        [](const std::filesystem::path& path) { return valueOf(readMaterialFile(path)); },
        nb::arg("path"), "Reads a material's JSON file.");
}

} // namespace idiophone::python
