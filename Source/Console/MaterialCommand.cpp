#include "Analysis/BodyModel.h"
#include "Analysis/RecordedMaterial.h"
#include "AudioFiles/AudioFileReader.h"
#include "Console/Command.h"
#include "Console/JsonText.h"
#include "Console/MaterialChoice.h"
#include "Console/OptionChecks.h"
#include "Console/ProgressLine.h"
#include "Geometry/MetricMesh.h"
#include "Object/FileBytes.h"
#include "Object/MaterialFile.h"
#include "Object/TextFile.h"

#include <iostream>
#include <optional>

namespace idiophone {
namespace {

struct MaterialOptions {
    std::filesystem::path recording;
    std::filesystem::path output;
    std::filesystem::path mesh;
    std::string name;
    std::optional<std::string> unit;
    double thicknessMetres = StruckObject{}.thicknessMetres;
    bool json = false;
};

Result<std::optional<StruckObject>> struckObject(const MaterialOptions& options) {
    if (options.mesh.empty())
        return std::nullopt;
    return readMetricMesh(options.mesh, options.unit).map([&](MetricMesh&& read) {
        return std::optional(
            StruckObject{.name = nameOf(options.mesh.filename()),
                         .mesh = std::move(read.mesh),
                         .thicknessMetres = options.thicknessMetres,
                         .notes = joinedSentences({read.notes, read.unitSentence})});
    });
}

void report(const RecordedMaterial& found, const MaterialOptions& options) {
    if (options.json) {
        auto result = describe(found.fit.material);
        result["resembles"] = found.fit.resembles;
        result["modes_matched"] = found.fit.matched;
        result["notes"] = found.notes;
        std::cout << jsonText(result);
        return;
    }
    std::cout << nameOf(options.output) << ": " << found.findings << '\n'
              << found.notes << std::endl;
}

Result<void> fitAndWriteMaterial(const MaterialOptions& options) {
    const auto recording = readRecording(options.recording);
    if (!recording)
        return tl::unexpected(recording.error());
    const auto object = struckObject(options);
    if (!object)
        return tl::unexpected(object.error());
    ProgressLine progress(nameOf(options.recording.filename()));
    const auto found =
        materialOfRecording({.name = nameOf(options.recording),
                             .samples = recording->samples,
                             .sampleRateHz = recording->sampleRateHz},
                            options.name.empty() ? nameOf(options.output.stem()) : options.name,
                            *object, progress.control());
    if (!found)
        return tl::unexpected(found.error());
    if (auto written = writeTextFile(options.output, encodeMaterial(found->fit.material)); !written)
        return written;
    report(*found, options);
    return {};
}

} // namespace

void addMaterial(CLI::App& program, Action& chosen) {
    const auto [command, options] = addCommand<MaterialOptions>(
        program, chosen, "material", "Makes a material from a recording of a struck object",
        fitAndWriteMaterial);
    command->add_option("RECORDING", options->recording, "A WAV, FLAC or AIFF file of one strike")
        ->required();
    command->add_option("-o,--output", options->output, "The material file (.json) to write")
        ->type_name(writtenFile)
        ->required();
    command->add_option("--mesh", options->mesh,
                        "Mesh of the struck object (default: only the damping is fitted)");
    command
        ->add_option("--unit", options->unit,
                     "Unit of the mesh file: m, cm, mm, in or ft (default: guessed)")
        ->check(unitOfLength());
    command->add_option("--thickness", options->thicknessMetres, "Thickness of a shell, in metres")
        ->check(numberBetween(1e-6, 10))
        ->capture_default_str();
    command->add_option("--name", options->name,
                        "Name of the material (default: of the output file)");
    command->add_flag("--json", options->json, "Writes the report as JSON");
}

} // namespace idiophone
