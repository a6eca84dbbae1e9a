#include "Console/AssignedEffect.h"
#include "Console/Command.h"
#include "Console/ImpulseRender.h"
#include "Console/OptionChecks.h"
#include "Console/ParameterAssignments.h"
#include "Console/PresetChoice.h"
#include "Console/SongRender.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/ScalaTuning.h"
#include "Object/FileBytes.h"
#include "Object/OneLine.h"
#include "Object/TextFile.h"
#include "Scene/SceneStage.h"

#include <algorithm>
#include <iostream>

namespace idiophone {
namespace {

using nlohmann::ordered_json;

struct RenderOptions {
    std::string preset;
    std::filesystem::path midi;
    std::filesystem::path impulses;
    std::filesystem::path scale;
    std::filesystem::path mapping;
    std::vector<std::string> assignments;
    RecordingFormat format;
    std::filesystem::path statistics;
    bool json = false;
};

ordered_json describe(const RenderTally& tally, const Recording& recording) {
    auto report = recording.statistics();
    const double seconds = report["seconds"];
    report["strikes"] = tally.strikes;
    report["modes_mixed_mean"] = tally.modesMixedMean;
    report["modes_mixed_max"] = tally.modesMixedMost;
    report["cpu_share"] = seconds > 0 ? ordered_json(tally.renderSeconds / seconds) : nullptr;
    return report;
}

Result<void>
report(const RenderTally& tally, const Recording& recording, const RenderOptions& options) {
    const auto statistics = describe(tally, recording);
    if (!options.statistics.empty())
        if (auto done = writeTextFile(options.statistics, statistics.dump(4) + "\n"); !done)
            return done;
    if (options.json)
        std::cout << statistics.dump(4) << std::endl;
    else
        std::cout << nameOf(options.format.file) << ": " << recording.summary() << ", "
                  << tally.strikes << " strikes, at most " << tally.modesMixedMost
                  << " modes at a time" << std::endl;
    return {};
}

Result<ScalaFile> readScalaFile(const std::filesystem::path& file) {
    if (file.empty())
        return ScalaFile{};
    return readTextFile(file, ScalaTuning::largestFileBytes).transform([&](std::string text) {
        return ScalaFile{.name = nameOf(file), .text = std::move(text)};
    });
}

Result<KeyTuning> readTuning(const RenderOptions& options) {
    const auto scale = readScalaFile(options.scale);
    if (!scale)
        return tl::unexpected(scale.error());
    const auto mapping = readScalaFile(options.mapping);
    if (!mapping)
        return tl::unexpected(mapping.error());
    return keyTuning({.scale = *scale, .mapping = *mapping});
}

/// Warns of options that the preset's keys cannot follow.
void warnOfTuning(const Preset& preset,
                  const Instrument& instrument,
                  const RenderOptions& options) {
    if (instrument.keysHaveObjects())
        return;
    for (const auto& [option, file] :
         {std::pair{"--scale", options.scale}, std::pair{"--mapping", options.mapping}})
        if (!file.empty())
            std::cerr << "warning: " << option << " has no effect, because the keys of "
                      << inQuotes(preset.name) << " share objects" << std::endl;
}

/// Returns the song's tuning messages that act; warns if there are some that do not.
std::span<const SongTuning>
tuningsOf(const MidiSong& song, const Instrument& instrument, const RenderOptions& options) {
    const bool hasFile = !options.scale.empty() || !options.mapping.empty();
    if (!song.tunings.empty() && (hasFile || !instrument.keysHaveObjects()))
        std::cerr << "warning: " << nameOf(options.midi)
                  << ": its tuning messages have no effect, because "
                  << (hasFile ? "--scale and --mapping override them"
                              : "the keys of the preset share objects")
                  << std::endl;
    return hasFile ? std::span<const SongTuning>() : song.tunings;
}

void warnOfNotes(const Preset& preset,
                 const Instrument& instrument,
                 const RenderTally& tally,
                 const RenderOptions& options) {
    if (tally.notesWithoutKey == 0)
        return;
    std::vector<int> keys;
    for (int note = 0; note < 128; ++note)
        if (instrument.key(note).slot >= 0)
            keys.push_back(note);
    std::cerr << "warning: " << nameOf(options.midi) << ": " << tally.notesWithoutKey << " of "
              << tally.strikes + tally.notesWithoutKey << " notes "
              << (tally.notesWithoutKey == 1 ? "is" : "are") << " no key of "
              << inQuotes(preset.name);
    if (!keys.empty())
        std::cerr << ", which plays " << keys.front() << " to " << keys.back();
    std::cerr << std::endl;
}

Result<RenderTally> playSong(const Preset& preset,
                             const ParameterValues& values,
                             std::span<const ParameterId> assigned,
                             const RenderOptions& options,
                             Recording& to) {
    auto instrument = buildInstrument(preset.keyMap, ObjectLibrary::shared());
    if (!instrument)
        return failure(options.preset + ": " + instrument.error().message);
    const auto tuning = readTuning(options);
    if (!tuning)
        return tl::unexpected(tuning.error());
    const auto song = readMidiSong(options.midi);
    if (!song)
        return tl::unexpected(song.error());
    warnOfTuning(preset, **instrument, options);
    const auto effect =
        assignedEffect(values, assigned,
                       {.by = (*instrument)->stage() ? PlayedBy::stage : PlayedBy::mallets,
                        .slots = (*instrument)->slots(),
                        .isPressed = std::ranges::any_of(song->events, &SongEvent::isPressure)});
    print(song->warnings);
    print(effect.warnings);
    Player player(std::move(*instrument), options.format.sampleRateHz, preset.surface, preset.seed,
                  preset.matched());
    player.setTuning(*tuning);
    player.setSilencedModes(silencedModes(player.instrument(), preset.mutedModes, {}));
    auto tally =
        renderSong(player, song->events, effect.values, to, nameOf(options.midi.filename()),
                   tuningsOf(*song, player.instrument(), options));
    if (tally)
        warnOfNotes(preset, player.instrument(), *tally, options);
    return tally;
}

Result<void> render(const RenderOptions& options) {
    const auto preset = findOrReadPreset(options.preset);
    if (!preset)
        return tl::unexpected(preset.error());
    auto values = withSetupOf({}, preset->parameters);
    const auto assigned = assignParameters(options.assignments, values);
    if (!assigned)
        return tl::unexpected(assigned.error());
    auto recording = Recording::start(options.format, values);
    if (!recording)
        return tl::unexpected(recording.error());
    const auto tally = options.midi.empty()
                           ? renderImpulses(options.impulses, values, *assigned, **recording)
                           : playSong(*preset, values, *assigned, options, **recording);
    if (!tally)
        return tl::unexpected(tally.error());
    return report(*tally, **recording, options);
}

} // namespace

void addRender(CLI::App& program, Action& chosen) {
    const auto [command, options] = addCommand<RenderOptions>(
        program, chosen, "render", "Renders a MIDI file or a list of impulses to a sound file",
        render);
    auto* preset = command->add_option("--preset", options->preset,
                                       "Name of a factory preset, or a preset file");
    auto* source = command->add_option_group("source", "Source of the notes or impulses");
    auto* midi = source->add_option("--midi", options->midi, "A Standard MIDI File")->needs(preset);
    source->add_option("--impulses", options->impulses,
                       "Contacts from a physics engine (docs/impulses.md)");
    source->require_option(1);
    command->add_option("--scale", options->scale, "A Scala scale (.scl) for the keys")
        ->needs(midi);
    command
        ->add_option("--mapping", options->mapping,
                     "A keyboard mapping (.kbm) of the scale's notes")
        ->needs(midi);
    addRecordingOptions(*command, options->format);
    addParameterAssignments(*command, options->assignments);
    command->add_option("--stats", options->statistics, "The JSON file to write statistics to")
        ->type_name(writtenFile);
    command->add_flag("--json", options->json, "Writes the statistics as JSON");
}

} // namespace idiophone
