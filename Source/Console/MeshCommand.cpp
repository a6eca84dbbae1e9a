#include "Console/Command.h"
#include "Console/OptionChecks.h"
#include "Geometry/MeshWriter.h"
#include "Geometry/SimpleShapes.h"
#include "Object/FileBytes.h"

#include <iostream>

namespace idiophone {
namespace {

struct MeshOptions {
    std::string kind;
    std::filesystem::path output;
    ShapeSizes sizes;
};

Result<void> makeMesh(const MeshOptions& options) {
    const auto mesh = simpleShape(options.kind, options.sizes);
    if (!mesh)
        return tl::unexpected(mesh.error());
    if (auto done = writeMesh(*mesh, options.output); !done)
        return done;
    std::cout << nameOf(options.output) << ": " << mesh->vertexCount() << " vertices, "
              << mesh->faceCount() << " faces" << std::endl;
    return {};
}

} // namespace

void addMesh(CLI::App& program, Action& chosen) {
    const auto [command, options] = addCommand<MeshOptions>(
        program, chosen, "mesh", "Makes the mesh of a simple shape", makeMesh);
    const auto names = simpleShapeNames();
    command->add_option("KIND", options->kind, "The shape")
        ->required()
        ->check(CLI::IsMember(std::vector<std::string>(names.begin(), names.end())));
    command->add_option("-o,--output", options->output, "The .obj or .ply file to write")
        ->type_name(writtenFile)
        ->required();
    const auto size = [&](const char* option, double& metres, const char* what) {
        return command->add_option(option, metres, what)->check(numberBetween(1e-4, 100));
    };
    auto& sizes = options->sizes;
    size("--length", sizes.lengthMetres, "Length of a bar, plate or box, in metres")
        ->capture_default_str();
    size("--width", sizes.widthMetres, "Width of a bar, plate or box")->capture_default_str();
    size("--height", sizes.heightMetres, "Height of a box, hoop or bowl")->capture_default_str();
    size("--radius", sizes.radiusMetres, "Radius of a disc, icosphere, ring, hoop or bowl's rim")
        ->capture_default_str();
    size("--section-radius", sizes.sectionRadiusMetres, "Radius of a ring's cross-section")
        ->capture_default_str();
    size("--foot-radius", sizes.footRadiusMetres,
         "Radius of a bowl's flat foot (default: two fifths of its rim's)");
    size("--thickness", sizes.thicknessMetres,
         "Thickness of a bowl's wall, for a solid (default: an open shell)");
    command->add_option("--vertices", sizes.vertexCount, "Approximate number of vertices")
        ->check(numberBetween(12, maximumShapeVertices))
        ->capture_default_str();
}

} // namespace idiophone
