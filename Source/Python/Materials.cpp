#include "Object/FileBytes.h"
#include "Object/MaterialFile.h"
#include "Python/Binding.h"

#include <fstream>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/vector.h>

namespace idiophone::python {

Material materialNamed(const std::string& name) {
    return valueOf(findAnyMaterial(name));
}

void bindMaterials(nb::module_& module) {
    nb::class_<Material>(module, "Material",
                         "What a body is made of. `Material(\"Glass\")` is one of the library, or "
                         "of the user's own; its figures may be changed.")
        .def(
            "__init__",
            [](Material* self, const std::string& name) {
                new (self) Material(materialNamed(name));
            },
            nb::arg("name"))
        .def_rw("name", &Material::name, "As in lists of materials.")
        .def_rw("youngs_modulus", &Material::youngsModulusPa, "In Pa; for wood along the grain.")
        .def_rw("density", &Material::densityKgPerM3, "In kg/m3.")
        .def_rw("poisson_ratio", &Material::poissonRatio, "Without a unit; 0.2 to 0.45 for most.")
        .def_prop_rw(
            "damping_fluid", [](const Material& self) { return self.damping.fluidPerSecond; },
            [](Material& self, double value) { self.damping.fluidPerSecond = value; },
            "Gamma in 1/s: amplitudes fall at the rate (gamma + chi omega + eta omega^2) / 2.")
        .def_prop_rw(
            "damping_viscoelastic",
            [](const Material& self) { return self.damping.viscoelasticSeconds; },
            [](Material& self, double value) { self.damping.viscoelasticSeconds = value; },
            "Eta in s: damping that grows with the square of the frequency.")
        .def_prop_rw(
            "loss_factor", [](const Material& self) { return self.damping.lossFactor; },
            [](Material& self, double value) { self.damping.lossFactor = value; },
            "Chi, without a unit: damping that grows with the frequency.")
        .def_rw("friction", &Material::friction, "The coefficient of friction in scenes.")
        .def_rw("restitution", &Material::restitution,
                "The speed after a collision over that before, in scenes.")
        .def_rw("roughness", &Material::roughness, "Of the surface, for scrapes and slides.")
        .def_rw("source", &Material::source, "Where the figures come from.")
        .def(
            "save",
            [](const Material& self, const std::filesystem::path& path) {
                std::ofstream file(path, std::ios::binary);
                if (!(file << encodeMaterial(valueOf(validated(self))) << std::flush))
                    throw nb::value_error((nameOf(path) + " cannot be written").c_str());
            },
            nb::arg("path"), "Writes a JSON file that the console and the window read.")
        .def("__getstate__", [](const Material& self) { return encodeMaterial(self); })
        .def("__setstate__",
             [](Material& self, const std::string& text) {
                 new (&self) Material(valueOf(parseMaterial(text, "a pickled material")));
             })
        .def("__repr__", [](const Material& self) { return "<Material '" + self.name + "'>"; });
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
