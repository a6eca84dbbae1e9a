#include "Console/AssignedEffect.h"
#include "Console/Command.h"
#include "Console/OptionChecks.h"
#include "Console/ParameterAssignments.h"
#include "Console/SceneRender.h"
#include "Console/SofaHead.h"
#include "Instrument/ImpulseLine.h"
#include "Instrument/ObjectLibrary.h"
#include "Object/EmbeddedFiles.h"
#include "Object/FileBytes.h"
#include "Object/OneLine.h"
#include "Object/TextFile.h"
#include "Scene/FactoryScenes.h"
#include "Scene/SceneFile.h"

#include <algorithm>
#include <iostream>

namespace idiophone {

std::span<const EmbeddedFile> songFiles(); // generated

namespace {

using nlohmann::ordered_json;

struct SceneOptions {
    std::string scene;
    std::filesystem::path midi;
    std::vector<std::string> assignments;
    RecordingFormat format;
    std::filesystem::path statistics;
    std::filesystem::path impulses;
    std::filesystem::path head;
    unsigned threads = 0;
    std::string stemKind;
    std::filesystem::path stemFolder;
    bool json = false;
};

Result<Scene> findOrReadScene(const std::string& nameOrFile) {
    if (const auto* factory = findFactoryScene(nameOrFile))
        return *factory;
    std::error_code ignored;
    if (!std::filesystem::exists(nameOrFile, ignored))
        return failure("'" + nameOrFile + "' is neither a file nor one of the scenes " +
                       factoryScenesInWords());
    return readSceneFile(nameOrFile);
}

ordered_json framesOf(const SceneTally& tally, std::int64_t FrameFigures::*figure) {
    auto frames = ordered_json::array();
    for (const auto& frame : tally.frames)
        frames.push_back(frame.*figure);
    return frames;
}

std::int64_t sumOf(const SceneTally& tally, std::int64_t FrameFigures::*figure) {
    std::int64_t sum = 0;
    for (const auto& frame : tally.frames)
        sum += frame.*figure;
    return sum;
}

std::int64_t mostOf(const SceneTally& tally, std::int64_t FrameFigures::*figure) {
    std::int64_t most = 0;
    for (const auto& frame : tally.frames)
        most = std::max(most, frame.*figure);
    return most;
}

ordered_json describe(const SceneTally& tally, const Recording& recording) {
    auto report = recording.statistics();
    const double seconds = report["seconds"];
    const auto frameCount = static_cast<double>(tally.frames.size());
    report["bodies_most"] = mostOf(tally, &FrameFigures::bodies);
    report["impacts"] = sumOf(tally, &FrameFigures::impacts);
    report["impacts_left_out"] = tally.impactsLeftOut;
    report["notes_left_out"] = tally.notesLeftOut;
    report["audio_frames_per_second"] = frameCount / tally.soundSeconds;
    report["motion_frames_per_second"] = frameCount / tally.motionSeconds;
    report["cpu_share_sound"] = seconds > 0 ? ordered_json(tally.soundSeconds / seconds) : nullptr;
    report["cpu_share_motion"] =
        seconds > 0 ? ordered_json(tally.motionSeconds / seconds) : nullptr;
    if (!tally.stems.empty())
        report["stems"] = tally.stems;
    report["frame_seconds"] = sceneFrameSeconds;
    report["bodies"] = framesOf(tally, &FrameFigures::bodies);
    report["impacts_of_frame"] = framesOf(tally, &FrameFigures::impacts);
    report["modes_mixed"] = framesOf(tally, &FrameFigures::modesMixed);
    report["modes_dropped"] = framesOf(tally, &FrameFigures::modesDropped);
    return report;
}

bool hasNamelessObjects(const SceneAssets& assets) {
    return std::ranges::any_of(
        assets.roles(), [](const auto& role) { return role.isHeard() && role.object.empty(); });
}

/// Returns the impacts in the format of docs/impulses.md.
std::string impulseLines(const SceneAssets& assets,
                         const std::vector<SceneImpact>& impacts,
                         const std::filesystem::path& list) {
    std::vector<std::string> objects;
    for (const auto& role : assets.roles())
        objects.push_back(objectInList(role.object, list));
    std::string lines;
    for (const auto& impact : impacts)
        lines += impulseLine(objects[impact.role], assets.slotOf(impact.role).sizeRatio,
                             {.seconds = impact.seconds,
                              .slot = impact.slot,
                              .strike = impact.strike,
                              .pointMetres = {impact.pointMetres.x(), impact.pointMetres.y(),
                                              impact.pointMetres.z()}});
    return lines;
}

Result<void>
report(const SceneTally& tally, const Recording& recording, const SceneOptions& options) {
    const auto statistics = describe(tally, recording);
    if (!options.statistics.empty())
        if (auto done = writeTextFile(options.statistics, statistics.dump() + "\n"); !done)
            return done;
    if (options.json)
        std::cout << statistics.dump() << std::endl;
    else
        std::cout << nameOf(options.format.file) << ": " << recording.summary() << ", "
                  << mostOf(tally, &FrameFigures::bodies) << " bodies, "
                  << sumOf(tally, &FrameFigures::impacts) << " impacts, at most "
                  << mostOf(tally, &FrameFigures::modesMixed) << " modes at a time" << std::endl;
    if (tally.notesLeftOut > 0)
        std::cerr << "warning: "
                  << (options.midi.empty() ? "The Entertainer" : nameOf(options.midi)) << ": "
                  << tally.notesLeftOut << " of its notes drop nothing" << std::endl;
    if (tally.impactsLeftOut > 0)
        std::cerr << "warning: " << tally.impactsLeftOut
                  << " impacts were left out, because they are not finite" << std::endl;
    return {};
}

/// Returns whether nothing moves without notes.
bool waitsForNotes(const Scene& scene) {
    return scene.noteDrop && !scene.hand &&
           std::ranges::all_of(scene.releases, [&](const Release& release) {
               return scene.kinds[release.kind].isFixed;
           });
}

/// Returns the song that drops bodies. Without a file it is the factory's, if nothing moves without
/// a song.
Result<MidiSong> songFor(const Scene& scene, const std::filesystem::path& file) {
    if (!file.empty())
        return readMidiSong(file);
    if (!waitsForNotes(scene))
        return MidiSong();
    const auto& song = songFiles().front();
    return parseMidiSong(song.bytes, std::string(song.name));
}

std::vector<SynthesiserSlot> heardSlots(const SceneAssets& assets) {
    std::vector<SynthesiserSlot> slots;
    for (std::size_t role = 0; role < assets.roles().size(); ++role)
        if (assets.roles()[role].isHeard())
            slots.push_back(assets.slotOf(role));
    return slots;
}

SceneStems stemsNamed(const std::string& kind) {
    return kind == "bodies"     ? SceneStems::bodies
           : kind == "contacts" ? SceneStems::contacts
                                : SceneStems::none;
}

Result<void> perform(const SceneOptions& options) {
    auto scene = findOrReadScene(options.scene);
    if (!scene)
        return tl::unexpected(scene.error());
    auto values = scene->parameters;
    const auto assigned = assignParameters(options.assignments, values);
    if (!assigned)
        return tl::unexpected(assigned.error());
    if (!options.midi.empty() && !scene->noteDrop)
        return failure(inQuotes(scene->name) + " has no 'notes', so a song drops nothing");
    const auto song = songFor(*scene, options.midi);
    if (!song)
        return tl::unexpected(song.error());
    const auto assets = SceneAssets::make(std::move(*scene), ObjectLibrary::shared());
    if (!assets)
        return tl::unexpected(assets.error());
    const auto slots = heardSlots(**assets);
    const auto effect = assignedEffect(values, *assigned, {.by = PlayedBy::scene, .slots = slots});
    print(song->warnings);
    print(effect.warnings);
    values = effect.values;
    SceneRenderSettings settings{.head = nullptr,
                                 .parameters = values,
                                 .threads = options.threads,
                                 .stems = stemsNamed(options.stemKind),
                                 .stemFolder = options.stemFolder};
    if (!options.head.empty()) {
        auto read = readSofaHead(options.head, options.format.sampleRateHz);
        if (!read)
            return tl::unexpected(read.error());
        settings.head = std::move(*read);
    }
    if (settings.stems != SceneStems::none)
        if (auto made = makeDirectory(options.stemFolder); !made)
            return made;
    auto recording = Recording::start(options.format, values);
    if (!recording)
        return tl::unexpected(recording.error());
    if (!options.impulses.empty() && hasNamelessObjects(**assets))
        return failure("--impulses: " + std::string(namelessObjects));
    const auto tally = renderScene(*assets, song->events, settings, **recording);
    if (!tally)
        return tl::unexpected(tally.error());
    if (!options.impulses.empty())
        if (auto done = writeTextFile(options.impulses,
                                      impulseLines(**assets, tally->impacts, options.impulses));
            !done)
            return done;
    return report(*tally, **recording, options);
}

} // namespace

void addScene(CLI::App& program, Action& chosen) {
    const auto [command, options] = addCommand<SceneOptions>(
        program, chosen, "scene", "Renders a scene of rigid bodies to a sound file", perform);
    command
        ->add_option("scene", options->scene,
                     "Name of a factory scene, or a scene file (.json, .gltf, .glb)")
        ->required();
    command->add_option(
        "--midi", options->midi,
        "A Standard MIDI File whose notes drop bodies (default: The Entertainer, if "
        "nothing moves without notes)");
    command->add_option("--head", options->head,
                        "A SOFA file of a measured head (default: a sphere)");
    auto* stems =
        command
            ->add_option("--stems", options->stemKind,
                         "Also writes stems that sum to the mix: bodies, or contacts (impacts, "
                         "slides, rolls)")
            ->check(CLI::IsMember({"bodies", "contacts"}));
    auto* stemFolder =
        command
            ->add_option("--stem-folder", options->stemFolder, "The folder to write the stems to")
            ->needs(stems);
    stems->needs(stemFolder);
    addRecordingOptions(*command, options->format);
    addParameterAssignments(*command, options->assignments);
    command
        ->add_option(
            "--threads", options->threads,
            "Threads that move and sound the bodies (default: one for each core, at most 4)")
        ->check(numberBetween(1, 64));
    command
        ->add_option("--stats", options->statistics,
                     "The JSON file to write statistics of each frame to")
        ->type_name(writtenFile);
    command
        ->add_option("--impulses", options->impulses,
                     "The file to write the impacts to, for `render --impulses`")
        ->type_name(writtenFile);
    command->add_flag("--json", options->json, "Writes the statistics as JSON");
}

} // namespace idiophone
