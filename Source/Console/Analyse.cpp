#include "Analysis/ModalAnalysis.h"
#include "Console/Command.h"
#include "Console/Interrupt.h"
#include "Console/JsonText.h"
#include "Console/MaterialChoice.h"
#include "Console/OptionChecks.h"
#include "Console/OutputCheck.h"
#include "Console/ProgressLine.h"
#include "Geometry/LengthUnit.h"
#include "Geometry/MeshReader.h"
#include "Object/ModalObjectFile.h"
#include "Object/NumberText.h"

#include <iomanip>
#include <iostream>
#include <optional>

namespace idiophone {
namespace {

using nlohmann::ordered_json;

struct Options {
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
    std::string radiation = "quick";
    bool json = false;
};

Result<AnalysisSettings> settingsFrom(const Options& options) {
    const auto material = findOrReadMaterial(options.material);
    if (!material)
        return tl::unexpected(material.error());
    const auto method = findMethod(options.method);
    if (!method && options.method != "auto")
        return failure("--method " + options.method +
                       ": it is none of auto, fem, two-layer, spring-mass and van-gelder");
    if (options.radiation != "quick" && options.radiation != "exact")
        return failure("--radiation " + options.radiation + ": it is neither quick nor exact");
    return AnalysisSettings{
        .name = options.name.empty() ? options.mesh.stem().string() : options.name,
        .source = options.mesh.filename().string(),
        .material = *material,
        .method = method,
        .thicknessMetres = options.thicknessMetres.value_or(AnalysisSettings{}.thicknessMetres),
        .maxFrequencyHz = options.maxFrequencyHz,
        .elementBudget = options.elementBudget,
        .largestComponentOnly = options.largestPart,
        .listeningDirections = options.allAround ? directionsAllAround() : stereoDirections(),
        .radiation =
            options.radiation == "exact" ? RadiationMethod::exact : RadiationMethod::quick};
}

/// Returns the requested unit or a guess, with a sentence if the guess is unsure or not metres.
Result<UnitGuess> unitOf(const Mesh& meshInFileUnits, const Options& options) {
    if (!options.unit) {
        UnitGuess guess = guessLengthUnit(meshInFileUnits);
        if (guess.isSure && guess.unit.metresPerUnit == 1)
            guess.sentence.clear();
        return guess;
    }
    const auto unit = lengthUnitNamed(*options.unit);
    if (!unit)
        return failure("--unit " + *options.unit + ": it is none of m, cm, mm, in and ft");
    return UnitGuess{.unit = *unit, .isSure = true, .sentence = {}};
}

Result<ModalObject> analyseFile(const Options& options) {
    const auto settings = settingsFrom(options);
    if (!settings)
        return tl::unexpected(settings.error());
    auto mesh = readMesh(options.mesh);
    if (!mesh)
        return tl::unexpected(mesh.error());
    const auto unit = unitOf(*mesh, options);
    if (!unit)
        return tl::unexpected(unit.error());
    mesh->vertices *= unit->unit.metresPerUnit;
    ProgressLine progress(options.mesh.filename().string());
    auto object = analyse(
        *mesh, *settings,
        {.progress = [&](double fraction, std::string_view step) { progress.show(fraction, step); },
         .cancelled = &interruptRequested()});
    if (!object && object.error().message != cancelledMessage)
        return failure(options.mesh.string() + ": " + object.error().message);
    if (object && !unit->sentence.empty()) {
        auto& notes = object->provenance.notes;
        notes = unit->sentence + (notes.empty() ? "" : " ") + notes;
    }
    return object;
}

void report(const ModalObject& object, const Options& options) {
    const auto& origin = object.provenance;
    if (options.json) {
        std::cout << jsonText({{"object", options.output.string()},
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
    std::cout << std::fixed << std::setprecision(1) << options.output.string() << ": "
              << object.modeCount() << " modes up to " << object.bandHz / 1000 << " kHz from "
              << origin.analysedVertices << " vertices, in " << origin.analysisSeconds << " s\n"
              << origin.zeroModes << " zero modes were left out.\n";
    if (!origin.notes.empty())
        std::cout << origin.notes << '\n';
}

Result<void> analyseAndWrite(const Options& options) {
    if (auto writable = checkWritable(options.output); !writable)
        return writable;
    const auto object = analyseFile(options);
    if (!object)
        return tl::unexpected(object.error());
    if (auto written = writeModalObject(*object, options.output); !written)
        return written;
    report(*object, options);
    if (options.thicknessMetres && object->body == BodyKind::solid)
        std::cerr << "warning: " << options.mesh.string()
                  << ": --thickness has no effect, because it was taken as a solid; --method "
                     "two-layer takes a shell"
                  << std::endl;
    return {};
}

} // namespace

void addAnalyse(CLI::App& program, Action& chosen) {
    auto* command = program.add_subcommand("analyse", "Makes a modal object from a triangle mesh");
    auto options = std::make_shared<Options>();
    command->add_option("MESH", options->mesh, "An .obj, .off, .ply or .stl file")->required();
    command->add_option("-o,--output", options->output, "The .modal file to write")
        ->type_name(writtenFile)
        ->required();
    command->add_option("--name", options->name, "The object's name; else the mesh file's");
    command->add_option("--material", options->material, "A material's name or a JSON file")
        ->capture_default_str();
    command->add_option("--thickness", options->thicknessMetres, "Of a shell, in metres")
        ->check(numberBetween(1e-6, 10))
        ->default_str(numberText(AnalysisSettings{}.thicknessMetres));
    command
        ->add_option("--method", options->method,
                     "auto (what suits the mesh), fem, two-layer, spring-mass or van-gelder")
        ->capture_default_str();
    command->add_option("--max-frequency", options->maxFrequencyHz, "End of the band, in Hz")
        ->check(numberBetween(100, 1e6))
        ->capture_default_str();
    command
        ->add_option("--elements", options->elementBudget,
                     "About how many tetrahedra a solid may have; fewer end its band earlier")
        ->check(CLI::Range(100, 200000))
        ->capture_default_str();
    command->add_option("--unit", options->unit,
                        "Of the mesh file: m, cm, mm, in or ft; else guessed from its size");
    command->add_flag("--largest-part", options->largestPart,
                      "Leaves all but the largest connected part out");
    command->add_flag("--all-around", options->allAround,
                      "Finds what is heard of it all around, for what turns in scenes, and not "
                      "only from the front");
    command
        ->add_option("--radiation", options->radiation,
                     "quick, or exact: boundary elements of full size, in up to minutes")
        ->capture_default_str();
    command->add_flag("--json", options->json, "Reports as JSON");
    command->final_callback(
        [options, &chosen] { chosen = [options] { return analyseAndWrite(*options); }; });
}

} // namespace idiophone
