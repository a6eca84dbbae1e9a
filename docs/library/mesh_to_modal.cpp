// A mesh and a material to a modal object, as a program of yours would ask for it.
//
//     mesh_to_modal MESH MATERIAL OBJECT.modal        (a mesh in metres)
#include "Analysis/ModalAnalysis.h"
#include "Geometry/MeshReader.h"
#include "Object/ModalObjectFile.h"

#include <cmath>
#include <iostream>
#include <numbers>

using namespace idiophone;

int fail(const std::string& sentence) {
    std::cerr << sentence << '\n';
    return 1;
}

int main(int count, char** arguments) {
    if (count != 4)
        return fail("mesh_to_modal MESH MATERIAL OBJECT.modal");
    const Material* material = findMaterial(arguments[2]);
    if (material == nullptr)
        return fail(std::string(arguments[2]) + ": there is no such material");
    const auto mesh = readMesh(arguments[1]);
    if (!mesh)
        return fail(mesh.error().message);

    const AnalysisSettings settings{
        .name = "mine", .source = arguments[1], .material = *material, .maxFrequencyHz = 22000};
    const auto showProgress = [](double fraction, std::string_view step) {
        std::cerr << static_cast<int>(100 * fraction) << " % " << step << '\n';
    };
    const auto object = analyse(*mesh, settings, {.progress = showProgress});
    if (!object)
        return fail(arguments[1] + (": " + object.error().message));
    for (const double eigenvalue : object->eigenvalues) // ω² in rad²/s², ascending
        std::cout << std::sqrt(eigenvalue) / (2 * std::numbers::pi) << " Hz\n";
    const auto written = writeModalObject(*object, arguments[3]);
    return written ? 0 : fail(written.error().message);
}
