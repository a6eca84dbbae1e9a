#include "Analysis/MaterialFit.h"
#include "AudioFiles/AudioFileReader.h"
#include "Console/Command.h"
#include "Console/JsonText.h"
#include "Console/MaterialChoice.h"
#include "Console/MetricMesh.h"
#include "Console/OptionChecks.h"
#include "Console/ProgressLine.h"
#include "Object/MaterialFile.h"
#include "Object/NumberText.h"
#include "Object/TextFile.h"

#include <array>
#include <cmath>
#include <iostream>
#include <optional>
#include <sstream>

namespace idiophone {
namespace {

struct MaterialOptions {
    std::filesystem::path recording;
    std::filesystem::path output;
    std::filesystem::path mesh;
    std::string name;
    std::optional<std::string> unit;
    double thicknessMetres = AnalysisSettings{}.thicknessMetres;
    bool json = false;
};

Result<MaterialFit>
fitOnMesh(const RecordingFit& modes, const MaterialOptions& options, const WorkControl& control) {
    const auto mesh = readMetricMesh(options.mesh, options.unit);
    if (!mesh)
        return tl::unexpected(mesh.error());
    AnalysisSettings settings;
    settings.name = settings.source = options.mesh.filename().string();
    settings.thicknessMetres = options.thicknessMetres;
    return fitMaterial(modes.modes, mesh->mesh, settings, control);
}

Result<MaterialFit>
fitted(const RecordingFit& modes, const MaterialOptions& options, const WorkControl& control) {
    auto fit =
        options.mesh.empty() ? fitDampingOnly(modes.modes) : fitOnMesh(modes, options, control);
    if (!fit)
        return fit;
    auto& material = fit->material;
    material.name = options.name.empty() ? options.output.stem().string() : options.name;
    material.source = (options.mesh.empty() ? "damping" : "stiffness and damping") +
                      std::string(" fitted to ") + options.recording.filename().string() +
                      "; all else is that of " + fit->resembles;
    return validated(material).map([&](const Material&) { return *fit; });
}

/// Returns sentences on the matched modes, the assumed figures and other readings.
std::string
notesOf(const MaterialFit& fit, const RecordingFit& modes, const MaterialOptions& options) {
    std::ostringstream notes;
    if (options.mesh.empty())
        notes << "Without a mesh only the damping is fitted. Stiffness";
    else
        notes << fit.matched << " of the " << modes.modes.size()
              << " modes are those of the mesh. Density";
    notes << (options.mesh.empty() ? ", density" : "") << " and contact figures are those of "
          << fit.resembles << ".";
    if (fit.otherRatio)
        notes << " A stiffness " << numberText(*fit.otherRatio, 3)
              << " times as high explains the modes nearly as well.";
    for (const auto& remark : modes.remarks)
        notes << ' ' << remark;
    return notes.str();
}

void report(const MaterialFit& fit, const std::string& notes, const MaterialOptions& options) {
    const auto& material = fit.material;
    if (options.json) {
        auto result = describe(material);
        result["resembles"] = fit.resembles;
        result["modes_matched"] = fit.matched;
        result["notes"] = notes;
        std::cout << jsonText(result);
        return;
    }
    std::cout << options.output.string() << ": like " << fit.resembles << ", speed of sound "
              << numberText(std::sqrt(material.youngsModulusPa / material.densityKgPerM3), 3)
              << " m/s; T60";
    for (const int hz : std::array{440, 1000, 4000})
        std::cout << (hz == 440 ? " " : ", ") << numberText(decaySeconds(material, hz), 3)
                  << " s at " << hz << " Hz";
    std::cout << '\n' << notes << std::endl;
}

Result<void> fitAndWriteMaterial(const MaterialOptions& options) {
    const auto recording = readRecording(options.recording);
    if (!recording)
        return tl::unexpected(recording.error());
    ProgressLine progress(options.recording.filename().string());
    const auto control = progress.control();
    constexpr double fitShare = 0.3;
    const auto modes =
        fitRecordings(std::array{StrikeRecording{.name = options.recording.string(),
                                                 .samples = recording->samples,
                                                 .sampleRateHz = recording->sampleRateHz}},
                      {}, control.part(0, fitShare));
    if (!modes)
        return tl::unexpected(modes.error());
    const auto fit = fitted(*modes, options, control.part(fitShare, 1));
    if (!fit)
        return isCancellation(fit.error())
                   ? tl::unexpected(fit.error())
                   : failure(options.recording.string() + ": " + fit.error().message);
    if (auto written = writeTextFile(options.output, encodeMaterial(fit->material)); !written)
        return written;
    report(*fit, notesOf(*fit, *modes, options), options);
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
    command->add_option("--unit", options->unit,
                        "Unit of the mesh file: m, cm, mm, in or ft (default: guessed)");
    command->add_option("--thickness", options->thicknessMetres, "Thickness of a shell, in metres")
        ->check(numberBetween(1e-6, 10))
        ->capture_default_str();
    command->add_option("--name", options->name,
                        "Name of the material (default: of the output file)");
    command->add_flag("--json", options->json, "Writes the report as JSON");
}

} // namespace idiophone
