#include "Plugin/PresetCollection.h"

#include "Editor/Utf8.h"
#include "Instrument/FactoryContent.h"
#include "Object/FileBytes.h"
#include "Object/OneLine.h"
#include "Object/TextFile.h"
#include "Plugin/FactoryPrograms.h"
#include "Plugin/ObjectEmbedding.h"
#include "Plugin/PresetObjects.h"
#include "Plugin/PresetSound.h"

namespace idiophone {
namespace {

juce::File below(const juce::File& settings, const char* name) {
    return settings == juce::File() ? settings : settings.getChildFile(name);
}

ShelvedPreset shelved(const Preset& preset, std::string id) {
    return {.id = std::move(id),
            .name = preset.name,
            .author = preset.author,
            .description = preset.description,
            .tags = preset.tags,
            .folder = {},
            .fault = {}};
}

/// Prefixes an error of a later step with `what`: the part that succeeded.
Result<void> butDone(const char* what, const Result<void>& after) {
    return after ? after : failure(what + after.error().message);
}

const Preset* factoryPreset(const std::string& id) {
    const int program = factoryProgram(id);
    return program < 0 ? nullptr : &factoryPresets()[static_cast<std::size_t>(program)];
}

} // namespace

PresetCollection::PresetCollection(SoundHolder& soundHolder,
                                   SoundHistory& soundHistory,
                                   const WorkshopView& workshopView,
                                   const juce::File& settings)
    : holder(soundHolder), history(soundHistory), workshop(workshopView),
      folder(below(settings, "Presets")), favourites(below(settings, "favourites.json")) {}

void PresetCollection::readPresets() {
    favourites.read();
    shelf.clear();
    for (const auto& preset : factoryPresets()) {
        shelf.push_back(shelved(preset, factoryPresetId(preset.name)));
        shelf.back().isFactory = true;
    }
    for (const auto& entry : folder.read()) {
        shelf.push_back(entry.preset ? shelved(*entry.preset, entry.id) : ShelvedPreset{});
        auto& last = shelf.back();
        last.id = entry.id;
        last.folder = entry.folder;
        if (!entry.preset) {
            const auto file = folder.fileOf(entry.id).getFileNameWithoutExtension().toStdString();
            last.name = oneLine(file); // the file name may not be UTF-8
            last.fault = entry.preset.error().message;
        }
    }
    for (auto& preset : shelf)
        preset.isFavourite = favourites.contains(preset.id);
}

PlayingPreset PresetCollection::playingPreset() const {
    auto playing = holder.playingPreset();
    if (const auto* entry = folder.find(playing.id))
        playing.details.folder = entry->folder;
    return playing;
}

Result<PresetCollection::FoundSound> PresetCollection::soundOf(const std::string& id) {
    if (const auto* preset = factoryPreset(id))
        return factorySound(*preset).map(
            [](Sound sound) { return FoundSound{.sound = std::move(sound), .notice = {}}; });
    if (folder.find(id) == nullptr)
        readPresets();
    const auto* entry = folder.find(id);
    if (entry == nullptr)
        return failure("There is no preset '" + id + "' any more.");
    if (!entry->preset)
        return tl::unexpected(entry->preset.error());
    return soundOfFile(*entry->preset, folder.fileOf(id), id, entry->content);
}

Result<PresetCollection::FoundSound> PresetCollection::soundOfFile(Preset preset,
                                                                   const juce::File& file,
                                                                   const std::string& id,
                                                                   std::uint64_t content) {
    const auto built = buildPresetInstrument(preset.keyMap, file);
    if (!built)
        return failure(preset.name + " cannot be played: " + built.error().message);
    preset.keyMap = built->keyMap; // with the absolute path of a scene: projects embed no scenes
    if (built->notice.empty())
        return FoundSound{.sound = soundWith(std::move(preset), built->instrument, id, content),
                          .notice = {}};
    // Give it no preset id, so that saving over the file must be confirmed.
    preset.mutedModes = {};
    const auto notice = preset.name + ": " + built->notice;
    return FoundSound{.sound = soundWith(std::move(preset), built->instrument, {}),
                      .notice = notice};
}

void PresetCollection::play(const FoundSound& found) {
    if (holder.playSound(found.sound) && !found.notice.empty())
        holder.reportError(found.notice);
}

Result<void> PresetCollection::load(const Result<FoundSound>& found) {
    return found.map([&](const FoundSound& loaded) {
        history.record(loaded.sound.preset.name, [&] { play(loaded); });
    });
}

Result<void> PresetCollection::loadPreset(const std::string& id) {
    return load(soundOf(id));
}

Result<void> PresetCollection::openPresetFile(const std::filesystem::path& file) {
    return load(readTextFile(file, largestPresetBytes)
                    .and_then([&](const std::string& text) {
                        return parsePreset(text, nameOf(file.filename()));
                    })
                    .and_then([&](const Preset& preset) {
                        return soundOfFile(preset, fileOf(file), {}, 0);
                    }));
}

Result<void> PresetCollection::loadInitialSound() {
    const auto preset = initialPreset();
    return buildInstrument(preset.keyMap, {}).map([&](std::shared_ptr<const Instrument> built) {
        const auto sound = soundWith(preset, std::move(built), {});
        history.record(preset.name, [&] { holder.playSound(sound); });
    });
}

Result<void> PresetCollection::auditionPreset(const std::string& id) {
    return soundOf(id).map(
        [&](const FoundSound& found) { history.audition([&] { play(found); }); });
}

bool PresetCollection::presetExists(const PresetDetails& details) const {
    const auto place = folder.placeFor(details.name, details.folder);
    return place && place->exists();
}

Result<void> PresetCollection::savePreset(const PresetDetails& details, bool replace) {
    if (!replace && presetExists(details))
        return failure("There is already a preset '" + details.name + "'.");
    return folder.placeFor(details.name, details.folder).and_then([&](const juce::File& file) {
        return save(holder.loadedSound(), details, file, [&](const Preset& preset) {
            return folder.write(preset, details.folder, replace);
        });
    });
}

Result<void> PresetCollection::saveChosenPreset() {
    const auto sound = holder.loadedSound();
    const auto& id = sound.presetId;
    if (folder.find(id) == nullptr)
        return failure("The current sound is no preset of yours, so there is nothing to replace.");
    if (auto same = folder.checkContent(id, sound.presetContent); !same) {
        readPresets(); // so that the user can load the present content
        return same;
    }
    return save(sound, detailsOf(sound.preset), folder.fileOf(id), [&](const Preset& preset) {
        return folder.replace(id, preset).map([&] { return id; });
    });
}

Result<void>
PresetCollection::save(Sound sound,
                       const PresetDetails& details,
                       const juce::File& file,
                       const std::function<Result<std::string>(const Preset&)>& write) {
    if (sound.instrument == nullptr)
        return failure("There is nothing to save: no instrument is loaded.");
    if (workshop.playsPreview())
        return failure("A preview plays: save it when the analysis is over, or cancel that first.");
    auto preset = sound.preset;
    preset.name = details.name;
    preset.author = details.author;
    preset.description = details.description;
    preset.tags = details.tags;
    storeValues(sound, preset);
    const auto replaced = PresetFolder::contentOf(file);
    return folder.folder()
        .and_then([&](const juce::File& root) {
            return writePresetObjects(preset.keyMap, *sound.instrument, root);
        })
        .and_then([&](const KeyMap& keyMap) {
            preset.keyMap = withSceneBeside(keyMap, file);
            return write(preset);
        })
        .map([&](const std::string& id) {
            // The sound plays on unchanged, with its loudness reference and the origin of its
            // objects. Only its name and preset id change.
            sound.preset = preset;
            sound.presetId = id;
            sound.presetContent = PresetFolder::contentOf(file);
            sound.stored = sound.parameters;
            holder.relabel(sound);
            // Undo steps may hold the former preset. Mark those as current too, so that they can be
            // saved over the file. Leave out steps from before another program wrote the file.
            history.renewSounds([&](Sound& known) {
                if (known.presetId != id || known.presetContent != replaced)
                    return;
                known.presetContent = sound.presetContent;
                known.stored = sound.stored;
            });
            readPresets();
        });
}

Result<void> PresetCollection::renamePreset(const std::string& id, const std::string& name) {
    if (factoryPreset(id) != nullptr)
        return failure("Factory presets keep their names.");
    const auto before = PresetFolder::contentOf(folder.fileOf(id));
    return folder.rename(id, name).and_then([&](const std::string& newId) {
        const auto content = PresetFolder::contentOf(folder.fileOf(newId));
        const auto rename = [&](Sound& known) {
            if (known.presetId != id)
                return false;
            known.preset.name = name;
            known.presetId = newId;
            // If another program changed the file meanwhile, keep the known hash, so that this
            // sound cannot replace that change.
            if (known.presetContent == before)
                known.presetContent = content;
            return true;
        };
        if (auto sound = holder.loadedSound(); rename(sound))
            holder.relabel(sound);
        history.renewSounds(rename);
        const auto renamed = favourites.rename(id, newId);
        readPresets();
        return butDone("It is renamed, but no favourite any more: ", renamed);
    });
}

Result<void> PresetCollection::deletePreset(const std::string& id) {
    if (factoryPreset(id) != nullptr)
        return failure("Factory presets are part of the program and stay.");
    return folder.moveToBin(id).and_then([&] {
        auto sound = holder.loadedSound();
        if (sound.presetId == id) {
            sound.presetId.clear();
            sound.presetContent = 0;
            holder.relabel(sound);
        }
        const auto forgotten = favourites.set(id, false);
        readPresets();
        return butDone("It is in the bin, but still among the favourites: ", forgotten);
    });
}

Result<void> PresetCollection::setFavourite(const std::string& id, bool favourite) {
    return favourites.set(id, favourite).map([this] { readPresets(); });
}

Result<std::string> PresetCollection::presetFolder() {
    return folder.folder().map(
        [](const juce::File& made) { return made.getFullPathName().toStdString(); });
}

} // namespace idiophone
