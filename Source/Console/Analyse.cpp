#include "Analysis/BodyModel.h"
#include "Analysis/ModalAnalysis.h"
#include "Console/Command.h"
#include "Console/JsonText.h"
#include "Console/MaterialChoice.h"
#include "Console/OptionChecks.h"
#include "Console/ProgressLine.h"
#include "Geometry/MetricMesh.h"
#include "Object/FileBytes.h"
#include "Object/ModalObjectFile.h"
#include "Object/NumberText.h"
#include "Object/OneLine.h"

#include <iomanip>
#include <iostream>
#include <optional>

namespace idiophone {
namespace {

using nlohmann::ordered_json;

struct AnalyseOptions {
    std::filesystem::path mesh;
    std::filesystem::path output;
    std::string name;
    std::string material = "Steel";
    std::string method = "auto";
    std::optional<double> thicknessMetres;
    double maxFrequencyHz = highestAnalysedHz;
    int elementBudget = AnalysisSettings{}.elementBudget;
    std::optional<std::string> unit;
    bool largestPart = false;
    bool allAround = false;
    std::vector<std::string> clamps;
    std::optional<double> supportResistanceNsPerM;
    std::string radiation = "quick";
    bool json = false;
};

/// Returns the name in "group:feet", or nothing for a region.
std::optional<std::string_view> groupOfClamp(std::string_view clamp) {
    constexpr std::string_view prefix = "group:";
    return clamp.starts_with(prefix) ? std::optional(clamp.substr(prefix.size())) : std::nullopt;
}

Result<AnalysisSettings> settingsFrom(const AnalyseOptions& options) {
    const auto material = findOrReadMaterial(options.material);
    if (!material)
        return tl::unexpected(material.error());
    Support support{.resistanceNsPerM = options.supportResistanceNsPerM};
    for (const auto& text : options.clamps) {
        if (groupOfClamp(text))
            continue; // the mesh has the groups
        const auto region = parseClamp(text);
        if (!region)
            return failure("--clamp: " + inQuotes(text) + " " + region.error().message);
        support.clamps.push_back(*region);
    }
    return AnalysisSettings{
        .name = options.name.empty() ? nameOf(options.mesh.stem()) : options.name,
        .source = nameOf(options.mesh.filename()),
        .material = *material,
        .method = findMethod(options.method), // nothing for auto
        .thicknessMetres = options.thicknessMetres.value_or(AnalysisSettings{}.thicknessMetres),
        .maxFrequencyHz = options.maxFrequencyHz,
        .elementBudget = options.elementBudget,
        .largestComponentOnly = options.largestPart,
        .support = std::move(support),
        .listeningDirections = options.allAround ? directionsAllAround() : stereoDirections(),
        .radiation =
            options.radiation == "exact" ? RadiationMethod::exact : RadiationMethod::quick};
}

Result<ModalObject> analyseFile(const AnalyseOptions& options) {
    auto settings = settingsFrom(options);
    if (!settings)
        return tl::unexpected(settings.error());
    const auto file = readMetricMesh(options.mesh, options.unit);
    if (!file)
        return tl::unexpected(file.error());
    for (const auto& text : options.clamps)
        if (const auto name = groupOfClamp(text)) {
            const auto group = findGroup(file->groups, *name);
            if (!group)
                return failure(nameOf(options.mesh) + ": --clamp: " + group.error().message);
            auto& faces = settings->support.faces;
            faces.insert(faces.end(), (*group)->faces.begin(), (*group)->faces.end());
        }
    ProgressLine progress(nameOf(options.mesh.filename()));
    auto object = analyse(file->mesh, *settings, progress.control());
    if (!object && object.error().message != cancelledMessage)
        return failure(nameOf(options.mesh) + ": " +
                       joinedSentences({object.error().message, file->unitSentence, file->notes}));
    if (object)
        object->provenance.notes =
            joinedSentences({file->notes, file->unitSentence, object->provenance.notes});
    return object;
}

void report(const ModalObject& object, const AnalyseOptions& options) {
    const auto& origin = object.provenance;
    if (options.json) {
        std::cout << jsonText({{"object", nameOf(options.output)},
                               {"name", object.name},
                               {"vertices", object.vertexCount()},
                               {"faces", object.faceCount()},
                               {"mode_count", object.modeCount()},
                               {"band_hz", object.bandHz},
                               {"method", object.method},
                               {"thickness_m", object.thicknessMetres},
                               {"mass_kg", object.mass.massKg},
                               {"zero_modes", origin.zeroModes},
                               {"notes", origin.notes},
                               {"analysis_s", origin.analysisSeconds}});
        return;
    }
    std::cout << std::fixed << std::setprecision(1) << nameOf(options.output) << ": "
              << object.modeCount() << " modes up to " << object.bandHz / 1000 << " kHz from "
              << origin.analysedVertices << " vertices, in " << origin.analysisSeconds << " s\n"
              << "It leaves out " << origin.zeroModes << " zero modes.\n";
    if (!origin.notes.empty())
        std::cout << origin.notes << '\n';
}

Result<void> analyseAndWrite(const AnalyseOptions& options) {
    const auto object = analyseFile(options);
    if (!object)
        return tl::unexpected(object.error());
    if (auto written = writeModalObject(*object, options.output); !written)
        return written;
    report(*object, options);
    if (options.thicknessMetres && object->body == BodyKind::solid)
        std::cerr << "warning: " << nameOf(options.mesh)
                  << ": --thickness has no effect on a solid; use --method two-layer for a shell"
                  << std::endl;
    return {};
}

} // namespace

void addAnalyse(CLI::App& program, Action& chosen) {
    const auto [command, options] = addCommand<AnalyseOptions>(
        program, chosen, "analyse", "Makes a modal object from a triangle mesh", analyseAndWrite);
    command->add_option("MESH", options->mesh, "An .obj, .off, .ply, .stl, .gltf or .glb file")
        ->required();
    command->add_option("-o,--output", options->output, "The .modal file to write")
        ->type_name(writtenFile)
        ->required();
    command->add_option("--name", options->name, "Name of the object (default: of the mesh file)");
    command->add_option("--material", options->material, "Name of a material, or a JSON file")
        ->capture_default_str();
    command->add_option("--thickness", options->thicknessMetres, "Thickness of a shell, in metres")
        ->check(numberBetween(1e-6, 10))
        ->default_str(numberText(AnalysisSettings{}.thicknessMetres));
    command->add_option("--method", options->method, "auto chooses a method for the mesh")
        ->check(CLI::IsMember({"auto", "fem", "two-layer", "spring-mass", "van-gelder"}))
        ->capture_default_str();
    command
        ->add_option("--max-frequency", options->maxFrequencyHz,
                     "Highest frequency analysed, in Hz")
        ->check(numberBetween(100, 1e6))
        ->capture_default_str();
    command
        ->add_option("--elements", options->elementBudget,
                     "Approximate number of tetrahedra of a solid; fewer give a lower band edge")
        ->check(CLI::Range(100, 200000))
        ->capture_default_str();
    command
        ->add_option("--unit", options->unit,
                     "Unit of the mesh file: m, cm, mm, in or ft (default: metres for glTF, else "
                     "guessed from its size)")
        ->check(unitOfLength());
    command->add_flag("--largest-part", options->largestPart,
                      "Analyses only the largest connected part");
    command
        ->add_option("--clamp", options->clamps,
                     "Holds the part where this is true, in metres: x<0.02 or x>0.1,z<0; or the "
                     "faces that the mesh file names: group:feet. May be repeated")
        ->type_name("REGION|group:NAME")
        ->take_all()
        ->expected(1);
    command
        ->add_option("--support-resistance", options->supportResistanceNsPerM,
                     "What the clamps take of the vibration: less, the higher this is, in N s/m "
                     "(default: nothing)")
        ->check(numberBetween(1e-3, 1e9));
    command->add_flag("--all-around", options->allAround,
                      "Computes the radiation in all directions, for bodies that turn in scenes");
    command
        ->add_option("--radiation", options->radiation,
                     "exact uses boundary elements of full size and takes up to minutes")
        ->check(CLI::IsMember({"quick", "exact"}))
        ->capture_default_str();
    command->add_flag("--json", options->json, "Writes the report as JSON");
}

} // namespace idiophone
