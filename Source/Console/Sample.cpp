#include "Console/Command.h"
#include "Console/Interrupt.h"
#include "Console/JsonText.h"
#include "Console/OptionChecks.h"
#include "Console/ParameterAssignments.h"
#include "Console/ProgressLine.h"
#include "Console/SampleOptions.h"
#include "Object/FileBytes.h"
#include "Object/NumberText.h"
#include "Object/WorkTeam.h"
#include "Sampling/SampleFolder.h"

#include <iostream>
#include <span>

namespace idiophone {
namespace {

using nlohmann::ordered_json;

Result<SampleFolder> render(const SampleOptions& options, const SampleTask& task) {
    auto settings = options.files;
    settings.folder = options.folder;
    WorkTeam team(options.threads);
    ProgressLine progress(task.sampled.preset.name);
    auto folder = exportTask(task, settings, team, progress.control());
    if (!folder && isCancellation(folder.error()))
        return failure(std::string(interruptedMessage));
    if (folder && folder->exported.clipped > 0)
        std::cerr << "warning: " << folder->exported.clipped
                  << " samples clip; a lower --gain avoids this" << std::endl;
    return folder;
}

ordered_json describe(const SampleTask& task, std::span<const SampleFigures> figures) {
    auto files = ordered_json::array();
    for (std::size_t i = 0; i < figures.size(); ++i) {
        if (task.places.empty())
            files.push_back({{"file", task.keys[i].name + task.ending},
                             {"key", task.keys[i].key},
                             {"velocity", task.keys[i].velocity},
                             {"round_robin", task.keys[i].roundRobin}});
        else
            files.push_back({{"file", task.places[i].name + task.ending},
                             {"place_m", task.places[i].placeMetres},
                             {"velocity", task.places[i].strike.velocity}});
        files.back()["peak_dbfs"] = figures[i].peakDecibels;
        files.back()["loudest_moment_lufs"] = figures[i].loudestMomentLufs;
        files.back()["seconds"] = figures[i].seconds;
    }
    return files;
}

Result<void> sample(const SampleOptions& options) {
    const auto task = planSampling(options);
    if (!task)
        return tl::unexpected(task.error());
    if (auto made = makeDirectory(options.folder); !made)
        return made;
    const auto folder = render(options, *task);
    if (!folder)
        return tl::unexpected(folder.error());
    const auto& exported = folder->exported;
    const auto index = nameOf(folder->index);
    const auto jobs = task->jobsIn(options.folder);
    if (!options.json) {
        std::cout << index << ": " << jobs.size() << " samples, " << exported.rendered
                  << " of them new, with a gain of " << numberText(exported.gainDecibels) << " dB"
                  << std::endl;
        return {};
    }
    const auto figures = task->places.empty() ? figuresOf(jobs) : folder->figures;
    if (!figures)
        return tl::unexpected(figures.error());
    std::cout << jsonText({{"index", index},
                           {"samples", jobs.size()},
                           {"rendered", exported.rendered},
                           {"gain_db", exported.gainDecibels},
                           {"sample_rate_hz", options.sampleRateHz},
                           {"tail_db", options.files.tailDecibels},
                           {"files", describe(*task, *figures)}});
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
