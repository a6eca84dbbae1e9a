#include "Console/Command.h"
#include "Console/OptionChecks.h"
#include "Geometry/MeshWriter.h"
#include "Geometry/ParametricMesh.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

namespace idiophone {
namespace {

struct MeshOptions {
    std::string kind;
    std::filesystem::path output;
    double lengthMetres = 0.4;
    double widthMetres = 0.05;
    double heightMetres = 0.02;
    double radiusMetres = 0.1;
    double sectionRadiusMetres = 0.01;
    int vertexCount = 1000;
};

constexpr double pi = std::numbers::pi;
constexpr int maximumVertices = 1000000; // requested maximum; proportions may double it

/// Returns the edge of near-equilateral triangles if `vertexCount` vertices cover an area.
double edgeFor(double areaM2, int vertexCount) {
    return std::sqrt(areaM2 / vertexCount * 2 / std::sqrt(3.0));
}

int divisions(double lengthMetres, double edgeMetres, int least) {
    return std::max(least, static_cast<int>(std::lround(lengthMetres / edgeMetres)));
}

int evenDivisions(double lengthMetres, double edgeMetres) {
    return 2 * divisions(lengthMetres / 2, edgeMetres, 3);
}

Mesh sheet(const MeshOptions& o) {
    return sheetMesh(o.lengthMetres, o.widthMetres, o.vertexCount);
}

Mesh box(const MeshOptions& o) {
    const Eigen::Vector3d size(o.lengthMetres, o.widthMetres, o.heightMetres);
    const double area = 2 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x());
    const double edge = std::sqrt(area / o.vertexCount);
    return boxMesh(size, {divisions(size.x(), edge, 1), divisions(size.y(), edge, 1),
                          divisions(size.z(), edge, 1)});
}

Mesh disc(const MeshOptions& o) {
    return discMesh(o.radiusMetres,
                    std::max(1, static_cast<int>(std::lround(std::sqrt(o.vertexCount / 3.0)))));
}

Mesh icosphere(const MeshOptions& o) {
    const double level = std::log2(std::max(1.0, (o.vertexCount - 2) / 10.0)) / 2;
    return icosphereMesh(o.radiusMetres, static_cast<int>(std::lround(level)));
}

Mesh ring(const MeshOptions& o) {
    const double around = 2 * pi * o.radiusMetres, section = 2 * pi * o.sectionRadiusMetres;
    const double edge = edgeFor(around * section, o.vertexCount);
    return torusMesh(o.radiusMetres, o.sectionRadiusMetres, evenDivisions(around, edge),
                     divisions(section, edge, 3));
}

Mesh hoop(const MeshOptions& o) {
    const double around = 2 * pi * o.radiusMetres;
    const double edge = edgeFor(around * o.heightMetres, o.vertexCount);
    return hoopMesh(o.radiusMetres, o.heightMetres, evenDivisions(around, edge),
                    divisions(o.heightMetres, edge * std::sqrt(3.0) / 2, 1));
}

struct Kind {
    std::string_view name;
    Mesh (*make)(const MeshOptions&);
};

constexpr Kind kinds[] = {{"bar", sheet},           {"plate", sheet}, {"box", box},  {"disc", disc},
                          {"icosphere", icosphere}, {"ring", ring},   {"hoop", hoop}};

Result<void> makeMesh(const MeshOptions& options) {
    const auto* kind = std::ranges::find(kinds, options.kind, &Kind::name);
    if (options.sectionRadiusMetres >= options.radiusMetres && options.kind == "ring")
        return failure("--section-radius: it must be smaller than the ring's radius");
    const auto mesh = kind->make(options);
    if (mesh.vertexCount() > 2 * maximumVertices)
        return failure("mesh " + options.kind + ": with these proportions it would have " +
                       std::to_string(mesh.vertexCount()) + " vertices");
    if (auto done = writeMesh(mesh, options.output); !done)
        return done;
    std::cout << options.output.string() << ": " << mesh.vertexCount() << " vertices, "
              << mesh.faceCount() << " faces" << std::endl;
    return {};
}

} // namespace

void addMesh(CLI::App& program, Action& chosen) {
    const auto [command, options] = addCommand<MeshOptions>(
        program, chosen, "mesh", "Makes the mesh of a simple shape", makeMesh);
    std::vector<std::string> names;
    for (const auto& kind : kinds)
        names.emplace_back(kind.name);
    command->add_option("KIND", options->kind, "The shape")
        ->required()
        ->check(CLI::IsMember(names));
    command->add_option("-o,--output", options->output, "The .obj or .ply file to write")
        ->type_name(writtenFile)
        ->required();
    const auto size = [&](const char* option, double& metres, const char* what) {
        command->add_option(option, metres, what)
            ->check(numberBetween(1e-4, 100))
            ->capture_default_str();
    };
    size("--length", options->lengthMetres, "Length of a bar, plate or box, in metres");
    size("--width", options->widthMetres, "Width of a bar, plate or box");
    size("--height", options->heightMetres, "Height of a box or hoop");
    size("--radius", options->radiusMetres, "Radius of a disc, icosphere, ring or hoop");
    size("--section-radius", options->sectionRadiusMetres, "Radius of a ring's cross-section");
    command->add_option("--vertices", options->vertexCount, "Approximate number of vertices")
        ->check(numberBetween(12, maximumVertices))
        ->capture_default_str();
}

} // namespace idiophone
