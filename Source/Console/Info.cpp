#include "Console/Command.h"
#include "Console/JsonText.h"
#include "Console/MaterialChoice.h"
#include "Geometry/MeshReader.h"
#include "Gltf/ObjectFile.h"
#include "Object/FileBytes.h"
#include "Synth/ModalPole.h"
#include "Synth/ModeCompression.h"

#include <cmath>
#include <iomanip>
#include <iostream>
#include <numbers>

namespace idiophone {
namespace {

using nlohmann::ordered_json;

struct InfoOptions {
    std::filesystem::path file;
    bool json = false;
};

constexpr std::size_t modesShown = 12;

struct ModeFigures {
    double frequencyHz = 0;  ///< damped; 0 beyond critical damping
    double decaySeconds = 0; ///< T60
};

PoleLaw lawOf(const ModalObject& object) {
    return {.damping = object.material.damping};
}

ModeFigures figuresOf(const ModalObject& object, std::size_t mode) {
    const auto pole = lawOf(object).pole(object.eigenvalues[mode], object.damping(mode));
    return {.frequencyHz = dampedFrequency(pole) / (2 * std::numbers::pi),
            .decaySeconds = std::log(1000.0) / decayBound(pole)};
}

std::size_t countGroups(const ModalObject& object) {
    std::vector<std::int32_t> starts(object.modeCount() + 1);
    return groupModes(object.eigenvalues, lawOf(object), 1, starts, object.dampings(), {},
                      object.gains);
}

/// A material without damping has an infinite T60, which JSON cannot express.
ordered_json finiteOrNull(double value) {
    return std::isfinite(value) ? ordered_json(value) : nullptr;
}

ordered_json describe(const ModalObject& object) {
    ordered_json modes = ordered_json::array();
    for (std::size_t mode = 0; mode < object.modeCount(); ++mode) {
        const auto figures = figuresOf(object, mode);
        modes.push_back({{"frequency_hz", figures.frequencyHz},
                         {"t60_s", finiteOrNull(figures.decaySeconds)},
                         {"eigenvalue", object.eigenvalues[mode]}});
    }
    return {{"name", object.name},
            {"vertices", object.vertexCount()},
            {"faces", object.faceCount()},
            {"shape_vertices", object.shapeVertexCount()},
            {"mode_count", object.modeCount()},
            {"modes_after_compression", countGroups(object)},
            {"method", object.method},
            {"body", object.body == BodyKind::shell ? "shell" : "solid"},
            {"thickness_m", object.thicknessMetres},
            {"band_hz", object.bandHz},
            {"radiation_directions", object.radiation.directions.size()},
            {"clamped_vertices", object.clampedVertices.size()},
            {"measured_decays", !object.decaysPerSecond.empty()},
            {"material", describe(object.material)},
            {"mass_kg", object.mass.massKg},
            {"centre_m", object.mass.centreMetres},
            {"inertia_kg_m2", object.mass.inertiaKgM2},
            {"provenance",
             {{"source", object.provenance.source},
              {"software", object.provenance.software},
              {"notes", object.provenance.notes},
              {"analysis_s", object.provenance.analysisSeconds},
              {"analysed_vertices", object.provenance.analysedVertices},
              {"zero_modes", object.provenance.zeroModes}}},
            {"modes", modes}};
}

void printModes(const ModalObject& object) {
    std::cout << "\n    Hz          T60 s\n";
    for (std::size_t mode = 0; mode < std::min(modesShown, object.modeCount()); ++mode) {
        const auto figures = figuresOf(object, mode);
        std::cout << "    " << std::left << std::setw(12) << std::setprecision(2)
                  << figures.frequencyHz << std::setprecision(3) << figures.decaySeconds << '\n';
    }
    if (object.modeCount() > modesShown)
        std::cout << "    and " << object.modeCount() - modesShown
                  << " more (--json lists them all)\n";
}

void print(const ModalObject& object) {
    const auto row = [](const char* title) -> std::ostream& {
        return std::cout << std::left << std::setw(14) << title;
    };
    const auto& origin = object.provenance;
    std::cout << std::fixed << std::setprecision(2);
    row("name") << shownName(object.name) << '\n';
    row("mesh") << object.vertexCount() << " vertices, " << object.faceCount() << " faces, "
                << object.shapeVertexCount() << " vertices with mode shapes\n";
    row("modes") << object.modeCount() << " up to " << object.bandHz / 1000 << " kHz, "
                 << countGroups(object) << " after compression\n";
    row("method") << shownName(object.method);
    if (object.body == BodyKind::shell)
        std::cout << ", a shell " << object.thicknessMetres * 1000 << " mm thick";
    std::cout << "\n";
    row("material") << shownName(object.material.name) << ", "
                    << object.material.youngsModulusPa / 1e9 << " GPa, "
                    << object.material.densityKgPerM3 << " kg/m³\n";
    row("mass") << std::setprecision(4) << object.mass.massKg << " kg\n";
    row("source") << shownName(origin.source) << " (" << shownName(origin.software) << ", "
                  << origin.analysedVertices << " vertices analysed";
    if (origin.analysisSeconds > 0)
        std::cout << " in " << std::setprecision(1) << origin.analysisSeconds << " s";
    std::cout << ")\n";
    row("zero modes") << origin.zeroModes << '\n';
    if (!origin.notes.empty())
        row("notes") << origin.notes << '\n';
    printModes(object);
}

/// Describes a mesh file and the groups that `analyse --clamp group:NAME` can hold.
Result<void> describeMesh(const InfoOptions& options) {
    const auto file = readMeshFile(options.file);
    if (!file)
        return tl::unexpected(file.error());
    if (options.json) {
        ordered_json groups = ordered_json::array();
        for (const auto& group : file->groups)
            groups.push_back({{"name", group.name}, {"faces", group.faces.size()}});
        std::cout << jsonText({{"vertices", file->mesh.vertexCount()},
                               {"faces", file->mesh.faceCount()},
                               {"notes", file->notes},
                               {"groups", groups}});
        return {};
    }
    std::cout << "mesh          " << file->mesh.vertexCount() << " vertices, "
              << file->mesh.faceCount() << " faces\n";
    if (!file->notes.empty())
        std::cout << "notes         " << file->notes << '\n';
    for (const auto& group : file->groups)
        std::cout << "group         " << shownName(group.name) << ", " << group.faces.size()
                  << (group.faces.size() == 1 ? " face\n" : " faces\n");
    return {};
}

Result<void> info(const InfoOptions& options) {
    if (isMeshFile(options.file) && !hasModalModel(options.file))
        return describeMesh(options);
    const auto object = readObject(options.file);
    if (!object)
        return tl::unexpected(object.error());
    if (options.json)
        std::cout << jsonText(describe(*object));
    else
        print(*object);
    return {};
}

} // namespace

void addInfo(CLI::App& program, Action& chosen) {
    const auto [command, options] = addCommand<InfoOptions>(
        program, chosen, "info", "Describes a modal object or a mesh", info);
    command->add_option("OBJECT", options->file, "A .modal file, or a mesh")->required();
    command->add_flag("--json", options->json, "Writes everything except the shapes as JSON");
}

} // namespace idiophone
