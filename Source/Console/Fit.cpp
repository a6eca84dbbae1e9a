#include "Analysis/BodyModel.h"
#include "Analysis/MeasuredObject.h"
#include "AudioFiles/AudioFileReader.h"
#include "AudioFiles/AudioFileWriter.h"
#include "Console/Command.h"
#include "Console/JsonText.h"
#include "Console/MaterialChoice.h"
#include "Console/OptionChecks.h"
#include "Console/ProgressLine.h"
#include "Geometry/MeshReader.h"
#include "Object/FileBytes.h"
#include "Object/ModalObjectFile.h"
#include "Object/NumberText.h"

#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>

namespace idiophone {
namespace {

struct FitOptions {
    std::vector<std::string> strikes; ///< RECORDING@PLACE
    std::filesystem::path output;
    std::string name;
    std::string material;
    std::filesystem::path mesh;
    std::optional<double> massKg;
    RecordingFitSettings fit;
    std::filesystem::path resynthesis;
    bool json = false;
};

struct RecordedStrike {
    std::filesystem::path file;
    StruckPlace place;
};

constexpr double maximumPointMetres = 1e4;

/// Splits at the last @, because a file name may contain some.
Result<RecordedStrike> parseStrike(const std::string& text) {
    const auto refuse = [&] {
        return failure(text +
                       ": it does not name a recording, an @ and a place (X,Y,Z or a radius, "
                       "in metres)");
    };
    const auto at = text.rfind('@');
    if (at == std::string::npos || at == 0)
        return refuse();
    std::vector<double> numbers;
    std::string_view rest = std::string_view(text).substr(at + 1);
    while (true) {
        const auto comma = rest.find(',');
        const auto number = parseNumber(rest.substr(0, comma));
        if (!number || !(std::abs(*number) <= maximumPointMetres))
            return refuse();
        numbers.push_back(*number);
        if (comma == std::string_view::npos)
            break;
        rest.remove_prefix(comma + 1);
    }
    RecordedStrike strike{.file = text.substr(0, at), .place = numbers[0]};
    if (numbers.size() == 3)
        strike.place = std::array{numbers[0], numbers[1], numbers[2]};
    else if (numbers.size() != 1 || numbers[0] < 0)
        return refuse();
    return strike;
}

/// `meshNotes` takes what is odd in the mesh.
Result<MeasuredObjectSettings> settingsFrom(const FitOptions& options,
                                            const std::vector<RecordedStrike>& strikes,
                                            std::string& meshNotes) {
    MeasuredObjectSettings settings;
    settings.name = options.name.empty() ? nameOf(options.output.stem()) : options.name;
    for (const auto& strike : strikes)
        settings.source += (settings.source.empty() ? "" : ", ") + nameOf(strike.file.filename());
    settings.massKg = options.massKg;
    if (!options.material.empty()) {
        auto material = findOrReadMaterial(options.material);
        if (!material)
            return tl::unexpected(material.error());
        settings.material = std::move(*material);
    }
    if (!options.mesh.empty()) {
        auto file = readMeshFile(options.mesh);
        if (!file)
            return tl::unexpected(file.error());
        settings.mesh = std::move(file->mesh);
        meshNotes = std::move(file->notes);
    }
    return settings;
}

Result<std::vector<MonoRecording>> readAll(const std::vector<RecordedStrike>& strikes) {
    std::vector<MonoRecording> recordings;
    for (const auto& strike : strikes) {
        auto recording = readRecording(strike.file);
        if (!recording)
            return tl::unexpected(recording.error());
        recordings.push_back(std::move(*recording));
    }
    return recordings;
}

/// The result refers to the arguments.
std::vector<StrikeRecording> viewsOf(const std::vector<RecordedStrike>& strikes,
                                     const std::vector<MonoRecording>& recordings) {
    std::vector<StrikeRecording> views;
    for (std::size_t i = 0; i < strikes.size(); ++i)
        views.push_back({.name = nameOf(strikes[i].file),
                         .samples = recordings[i].samples,
                         .sampleRateHz = recordings[i].sampleRateHz});
    return views;
}

/// Writes what the modes alone say in the only recording.
Result<void> writeResynthesis(const RecordingFit& fit,
                              const StrikeRecording& recording,
                              const std::filesystem::path& file) {
    constexpr int channels = 1;
    const auto samples = resynthesised(fit, 0, recording);
    const auto rate = static_cast<int>(std::lround(recording.sampleRateHz));
    auto writer =
        AudioFileWriter::create(file, rate, channels, AudioFileWriter::usualBitDepth(file));
    if (!writer)
        return tl::unexpected(writer.error());
    const float* const channel = samples.data();
    if (auto written = (*writer)->write(&channel, static_cast<int>(samples.size())); !written)
        return written;
    return (*writer)->finish();
}

/// Returns the notes on the fit that the object does not contain.
std::string notesOf(const RecordingFit& fit, const ModalObject& object, const FitOptions& options) {
    std::ostringstream notes;
    notes << fit.modes.size() << " of the " << fit.modesFound << " modes found.";
    if (options.material.empty())
        notes << std::setprecision(3) << " Its material is unknown. A damping of gamma "
              << object.material.damping.fluidPerSecond << " 1/s, loss factor "
              << object.material.damping.lossFactor << " and eta "
              << object.material.damping.viscoelasticSeconds
              << " s was fitted to its decays. All other figures are those of steel.";
    if (!options.massKg && (options.mesh.empty() || options.material.empty()))
        notes << " Its mass is unknown. It is as loud as an object of " << std::setprecision(3)
              << object.mass.massKg << " kg.";
    for (const auto& remark : fit.remarks)
        notes << ' ' << remark;
    return notes.str();
}

void report(const ModalObject& object, const RecordingFit& fit, const FitOptions& options) {
    if (options.json) {
        auto modes = nlohmann::ordered_json::array();
        for (const auto& mode : fit.modes)
            modes.push_back({{"frequency_hz", mode.frequencyHz},
                             {"t60_s", std::log(1000) / mode.decayPerSecond},
                             {"amplitudes", mode.amplitudes}});
        auto rests = nlohmann::ordered_json::array();
        for (const auto& rest : fit.rests)
            rests.push_back({{"modes", rest.modes},
                             {"contact", rest.contact},
                             {"steady_tones", rest.steadyTones},
                             {"steady_hz", rest.steadyHz},
                             {"noise", rest.noise},
                             {"others", rest.others}});
        std::cout << jsonText({{"object", nameOf(options.output)},
                               {"name", object.name},
                               {"vertices", object.vertexCount()},
                               {"mode_count", object.modeCount()},
                               {"modes_found", fit.modesFound},
                               {"unexplained_db", fit.noiseDecibels},
                               {"rests", rests},
                               {"material", describe(object.material)},
                               {"mass_kg", object.mass.massKg},
                               {"notes", object.provenance.notes},
                               {"analysis_s", object.provenance.analysisSeconds},
                               {"modes", modes}});
        return;
    }
    std::cout << std::fixed << std::setprecision(1) << nameOf(options.output) << ": "
              << object.modeCount() << " modes from " << fit.modes.front().frequencyHz << " to "
              << fit.modes.back().frequencyHz << " Hz, from " << fit.noiseDecibels.size()
              << (fit.noiseDecibels.size() == 1 ? " recording, in " : " recordings, in ")
              << object.provenance.analysisSeconds << " s\n"
              << "Level of the recordings without the modes:";
    for (const double level : fit.noiseDecibels)
        std::cout << ' ' << level;
    std::cout << " dB\n";
    for (const auto& rest : fit.rests)
        std::cout << rest.sentence() << '\n';
    std::cout << object.provenance.notes << std::endl;
}

Result<void> fitAndWrite(const FitOptions& options) {
    std::vector<RecordedStrike> strikes;
    for (const auto& text : options.strikes) {
        auto strike = parseStrike(text);
        if (!strike)
            return tl::unexpected(strike.error());
        strikes.push_back(std::move(*strike));
    }
    std::string meshNotes;
    const auto settings = settingsFrom(options, strikes, meshNotes);
    if (!settings)
        return tl::unexpected(settings.error());
    if (!options.resynthesis.empty() && strikes.size() != 1)
        return failure("--resynthesis needs exactly one recording, and there are " +
                       std::to_string(strikes.size()) + ".");
    const auto start = std::chrono::steady_clock::now();
    const auto recordings = readAll(strikes);
    if (!recordings)
        return tl::unexpected(recordings.error());
    const auto views = viewsOf(strikes, *recordings);
    ProgressLine progress(nameOf(strikes.front().file.filename()));
    const auto fit = fitRecordings(views, options.fit, progress.control());
    if (!fit)
        return tl::unexpected(fit.error());
    std::vector<StruckPlace> places;
    for (const auto& strike : strikes)
        places.push_back(strike.place);
    auto object = measuredObject(*fit, places, *settings);
    if (!object)
        return tl::unexpected(object.error());
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    object->provenance.analysisSeconds = taken.count();
    object->provenance.notes = joinedSentences({meshNotes, notesOf(*fit, *object, options)});
    if (auto written = writeModalObject(*object, options.output); !written)
        return written;
    if (!options.resynthesis.empty())
        if (auto written = writeResynthesis(*fit, views.front(), options.resynthesis); !written)
            return written;
    report(*object, *fit, options);
    return {};
}

} // namespace

void addFit(CLI::App& program, Action& chosen) {
    const auto [command, options] = addCommand<FitOptions>(
        program, chosen, "fit", "Makes a modal object from recordings of strikes", fitAndWrite);
    command
        ->add_option(
            "RECORDING@PLACE", options->strikes,
            "WAV, FLAC or AIFF files of one strike each, with the struck place: X,Y,Z or a "
            "radius, in metres")
        ->required();
    command->add_option("-o,--output", options->output, "The .modal file to write")
        ->type_name(writtenFile)
        ->required();
    command->add_option("--name", options->name,
                        "Name of the object (default: of the output file)");
    command
        ->add_option("--modes", options->fit.modeCount,
                     "Maximum number of modes; the strongest are kept")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_option(
        "--mesh", options->mesh,
        "Mesh of the struck object, in metres (default: a surface through the places)");
    command->add_option("--material", options->material,
                        "Name of a material, or a JSON file (default: the damping is fitted)");
    command->add_option("--mass", options->massKg, "Mass in kilograms")
        ->check(numberBetween(1e-6, 1e6));
    command
        ->add_option("--contact-time", options->fit.contactSeconds,
                     "Contact time of the mallet in seconds; its spectrum is removed")
        ->check(numberBetween(1e-6, 0.1));
    command
        ->add_option("--resynthesis", options->resynthesis,
                     "WAV or FLAC file to write: what the modes alone say in the recording, at "
                     "its level")
        ->type_name(writtenFile);
    command->add_flag("--json", options->json, "Writes the report as JSON");
}

} // namespace idiophone
