#include "AudioFiles/AudioFileReader.h"
#include "Console/Command.h"
#include "Console/FileName.h"
#include "Console/Interrupt.h"
#include "Console/JsonText.h"
#include "Console/LoudnessMeter.h"
#include "Console/OptionChecks.h"
#include "Console/ParameterAssignments.h"
#include "Console/ProgressLine.h"
#include "Console/SampleTask.h"
#include "Object/NumberText.h"
#include "Object/TextFile.h"
#include "Object/WorkTeam.h"
#include "Sampling/SfzText.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace idiophone {
namespace {

using nlohmann::ordered_json;

/// Loudness and length of a file, as it lies on the disk.
struct FileFigures {
    double seconds = 0, peakDecibels = 0, loudestMomentLufs = 0;
};

Result<FileFigures> figuresOf(const std::filesystem::path& file) {
    auto sound = readChannels(file);
    if (!sound)
        return tl::unexpected(sound.error());
    const auto channels = static_cast<std::size_t>(sound->channelCount);
    FileFigures figures;
    figures.seconds = static_cast<double>(sound->samples.size() / channels) / sound->sampleRateHz;
    double peak = 0;
    for (const float sample : sound->samples)
        peak = std::max(peak, std::abs(static_cast<double>(sample)));
    figures.peakDecibels = 20 * std::log10(peak);
    // Silence behind a short sound gives it the 400 ms that loudness takes.
    const auto rate = static_cast<int>(sound->sampleRateHz);
    sound->samples.resize(sound->samples.size() + channels * static_cast<std::size_t>(rate) / 2);
    figures.loudestMomentLufs = loudestMomentLufs(sound->samples, sound->channelCount, rate);
    return figures;
}

Result<std::string>
writeSfz(const SampleOptions& options, const SampleTask& task, double gainDecibels) {
    const auto& sampled = task.sampled;
    SfzInstrument sfz{.name = sampled.preset.name,
                      .folder = "",
                      .ending = "." + options.ending,
                      .gainDecibels = gainDecibels,
                      .tailDecibels = options.files.tailDecibels,
                      .keysHavePitches = sampled.preset.keyMap.kind != KeyMapKind::zones,
                      .releaseSeconds = {}};
    if (sampled.values[ParameterId::letRing] == 0)
        sfz.releaseSeconds = sampled.values[ParameterId::releaseTime];
    const auto file =
        options.folder /
        fileNameFrom((sampled.preset.name.empty() ? "Instrument" : sampled.preset.name) + ".sfz");
    if (auto done = writeTextFile(file, sfzText(sfz, task.plan)); !done)
        return tl::unexpected(done.error());
    return file.string();
}

Result<std::string> writeTable(const SampleOptions& options, const ordered_json& files) {
    std::string table = "file,x_m,y_m,z_m,velocity,peak_dbfs,loudest_moment_lufs,seconds\n";
    for (const auto& row : files) {
        table += row["file"].get<std::string>();
        for (const double metres : row["place_m"])
            table += "," + numberText(metres + 0.0); // no "-0"
        table += "," + std::to_string(row["velocity"].get<int>());
        for (const auto* figure : {"peak_dbfs", "loudest_moment_lufs", "seconds"})
            table += "," + numberText(row[figure].get<double>());
        table += "\n";
    }
    const auto file = options.folder / "samples.csv";
    if (auto done = writeTextFile(file, table); !done)
        return tl::unexpected(done.error());
    return file.string();
}

Result<ordered_json> describeFiles(const SampleTask& task) {
    auto files = ordered_json::array();
    for (std::size_t i = 0; i < task.jobs.size(); ++i) {
        const auto figures = figuresOf(task.jobs[i].file);
        if (!figures)
            return tl::unexpected(figures.error());
        auto row = task.names[i];
        row["peak_dbfs"] = figures->peakDecibels;
        row["loudest_moment_lufs"] = figures->loudestMomentLufs;
        row["seconds"] = figures->seconds;
        files.push_back(std::move(row));
    }
    return files;
}

Result<ExportedSamples> render(const SampleOptions& options, const SampleTask& task) {
    auto settings = options.files;
    settings.folder = options.folder;
    WorkTeam team(options.threads);
    ProgressLine progress(task.sampled.preset.name);
    auto exported = exportSamples(task.sampled, task.jobs, settings, team, progress.control());
    if (!exported && isCancellation(exported.error()))
        return failure(std::string(interruptedMessage));
    if (exported && exported->clipped > 0)
        std::cerr << "warning: " << exported->clipped << " samples clip; a lower --gain avoids this"
                  << std::endl;
    return exported;
}

Result<void> sample(const SampleOptions& options) {
    const auto planned = planSampling(options);
    if (!planned)
        return tl::unexpected(planned.error());
    const auto& task = *planned;
    if (auto made = makeDirectory(options.folder); !made)
        return made;
    const auto exported = render(options, task);
    if (!exported)
        return tl::unexpected(exported.error());
    const auto files = describeFiles(task);
    if (!files)
        return tl::unexpected(files.error());
    const auto index = options.places ? writeTable(options, *files)
                                      : writeSfz(options, task, exported->gainDecibels);
    if (!index)
        return tl::unexpected(index.error());
    if (options.json)
        std::cout << jsonText({{"index", *index},
                               {"samples", task.jobs.size()},
                               {"rendered", exported->rendered},
                               {"gain_db", exported->gainDecibels},
                               {"sample_rate_hz", options.sampleRateHz},
                               {"tail_db", options.files.tailDecibels},
                               {"files", *files}});
    else
        std::cout << *index << ": " << task.jobs.size() << " samples, " << exported->rendered
                  << " of them new, with a gain of " << numberText(exported->gainDecibels) << " dB"
                  << std::endl;
    return {};
}

} // namespace

void addSample(CLI::App& program, Action& chosen) {
    const auto [command, options] = addCommand<SampleOptions>(
        program, chosen, "sample",
        "Renders an instrument's strikes to files, for samplers and games", sample);
    command
        ->add_option("INSTRUMENT", options->instrument,
                     "Name of a factory preset, a preset file, or with --places a .modal file")
        ->required();
    command->add_option("-o,--output", options->folder, "The folder to write the samples to")
        ->required();
    auto* places = command
                       ->add_option("--places", options->places,
                                    "Strikes one object at so many places, spread over it")
                       ->check(numberBetween(1, 1000));
    command
        ->add_option("--keys", options->keys, "Lowest and highest key (default: all with objects)")
        ->type_name("LOWEST-HIGHEST")
        ->delimiter('-')
        ->expected(2)
        ->check(numberBetween(0, 127))
        ->excludes(places);
    command->add_option("--every", options->choices.every, "Samples every nth key")
        ->check(numberBetween(1, 127))
        ->capture_default_str()
        ->excludes(places);
    command->add_option("--velocities", options->choices.velocities, "Layers of velocity")
        ->check(numberBetween(1, 127))
        ->capture_default_str();
    command
        ->add_option("--round-robins", options->choices.roundRobins,
                     "Different strikes that take turns")
        ->check(numberBetween(1, 100))
        ->capture_default_str()
        ->excludes(places);
    command->add_option("--format", options->ending, "wav or flac")
        ->check(CLI::IsMember({"wav", "flac"}))
        ->capture_default_str();
    command->add_option("--bit-depth", options->files.bitDepth, "16 or 24")
        ->check(CLI::IsMember({16, 24}))
        ->capture_default_str();
    command->add_option("--sample-rate", options->sampleRateHz, "Sample rate in Hz")
        ->check(numberBetween(8000, 384000))
        ->capture_default_str();
    command
        ->add_option("--tail", options->files.tailDecibels,
                     "Where a sample ends, in dB relative to its peak")
        ->check(numberBetween(-120, -20))
        ->capture_default_str();
    command->add_option("--seconds", options->files.longestSeconds, "Maximum length of a sample")
        ->check(numberBetween(0.01, 600))
        ->capture_default_str();
    command
        ->add_option("--gain", options->files.gainDecibels,
                     "Gain of all samples in dB (default: the loudest strike peaks at -3 dBFS)")
        ->check(numberBetween(-60, 60));
    command
        ->add_option("--threads", options->threads,
                     "Threads that render (default: one for each core, at most 4)")
        ->check(numberBetween(1, 64));
    addParameterAssignments(*command, options->assignments);
    command->add_flag("--json", options->json, "Writes the report as JSON");
}

} // namespace idiophone
