#include "Plugin/PresetObjects.h"

#include "Editor/Utf8.h"
#include "Instrument/FactoryContent.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/PresetFile.h"
#include "Object/FileBytes.h"
#include "Plugin/ContentHash.h"
#include "Plugin/ObjectEmbedding.h"
#include "Plugin/WholeFile.h"
#include "Plugin/WithinMemory.h"
#include "Scene/FactoryScenes.h"
#include "Scene/SceneFile.h"
#include "Scene/SceneStage.h"

#include <algorithm>
#include <map>

namespace idiophone {
namespace {

using Bytes = std::vector<std::byte>;

/// Returns the .modal files of all notes of a map that is no kit, by object name; none if all are
/// factory objects.
std::map<std::string, Bytes> filesOf(const KeyMap& map, const std::vector<ForeignObject>& foreign) {
    std::map<std::string, Bytes> files;
    const auto names = objectNames(map);
    for (const auto& [name, object] : foreign)
        if (std::ranges::find(names, name) != names.end())
            files.emplace(name, modalFile(*object));
    if (files.empty())
        return files;
    for (const auto& name : names)
        if (const auto factory = factoryObject(name))
            files.try_emplace(name, factory->begin(), factory->end());
    return files;
}

/// Returns the object's name as far as a file name can hold it.
juce::String fileStem(const KeyMap& keyMap) {
    // The project may come from Windows.
    const auto name = fromUtf8(keyMap.object).replace("{note}", "").replaceCharacter('\\', '/');
    const auto last = name.trimCharactersAtEnd("/").fromLastOccurrenceOf("/", false, false);
    const auto legal =
        juce::File::createLegalFileName(last.upToLastOccurrenceOf(".", false, false))
            .upToLastOccurrenceOf("-", false, false) // cut the hash that writePresetObjects appends
            .substring(0, 60)
            .trim();
    return legal.isEmpty() ? "Object" : legal;
}

bool holds(const juce::File& file, const Bytes& bytes) {
    juce::MemoryBlock present;
    return file.loadFileAsData(present) && present.matches(bytes.data(), bytes.size());
}

using KeptObjects = std::map<std::string, std::shared_ptr<const ModalObject>>;

/// Adds the objects of `found` to a library under the names of `keyMap`, and keeps them alive.
Result<void>
addObjects(const KeyMap& keyMap, const KeyMap& found, ObjectLibrary& own, KeptObjects& kept) {
    auto foundPart = found.parts.begin();
    for (const auto& part : keyMap.parts)
        if (auto added = addObjects(part.keyMap, (foundPart++)->keyMap, own, kept); !added)
            return added;
    if (keyMap.kind == KeyMapKind::kit)
        return {};
    for (int note = keyMap.lowestNote; note <= keyMap.highestNote; ++note) {
        const auto name = keyMap.objectFor(note);
        if (kept.contains(name) || factoryObject(name))
            continue;
        if (note > keyMap.lowestNote && !ObjectLibrary::shared().has(found.objectFor(note)))
            continue; // this key has no object of its own
        auto object = ObjectLibrary::shared().find(found.objectFor(note));
        if (!object)
            return tl::unexpected(object.error());
        own.add(name, *object);
        kept.emplace(name, std::move(*object));
    }
    return {};
}

/// Builds an instrument with the objects of `found` under the names of `keyMap`.
Result<std::shared_ptr<const Instrument>> buildWith(const KeyMap& keyMap, const KeyMap& found) {
    if (found == keyMap)
        return buildInstrument(keyMap, ObjectLibrary::shared());
    // A library in which the names of `keyMap` mean these objects; the objects stay shared.
    ObjectLibrary own(ObjectLibrary::shared());
    KeptObjects kept;
    return addObjects(keyMap, found, own, kept).and_then([&] {
        return buildInstrument(keyMap, own);
    });
}

Result<PresetInstrument> buildFound(const KeyMap& keyMap, const juce::File& presetFile) {
    const auto found = withObjectsBeside(keyMap, pathOf(presetFile));
    if (const auto missing = firstMissing(found, {})) {
        const auto standIn = standInFor(keyMap);
        return buildInstrument(standIn, ObjectLibrary::shared()).transform([&](auto built) {
            return PresetInstrument{.keyMap = standIn,
                                    .instrument = std::move(built),
                                    .notice = *missing + " is missing; a steel ring plays in its "
                                                         "place."};
        });
    }
    const bool isScene = keyMap.kind == KeyMapKind::scene;
    const auto& played = isScene ? found : keyMap;
    return (isScene ? buildInstrument(found, ObjectLibrary::shared()) : buildWith(keyMap, found))
        .and_then(fitForState)
        .transform([&](auto built) {
            return PresetInstrument{
                .keyMap = played, .instrument = std::move(built), .notice = std::string()};
        });
}

/// Writes the objects of a map that is no kit.
Result<KeyMap> writeObjects(const KeyMap& keyMap,
                            const std::vector<ForeignObject>& foreign,
                            const juce::File& folder) {
    const auto files = filesOf(keyMap, foreign);
    if (files.empty())
        return keyMap;
    auto hash = contentHash({});
    for (const auto& [name, bytes] : files)
        hash = contentHash(bytes, hash);
    const bool isOne = files.size() == 1 && keyMap.objectFor(0) == keyMap.objectFor(1);
    std::vector<int> notes; // one note for each file
    for (int note = keyMap.lowestNote; note <= (isOne ? keyMap.lowestNote : keyMap.highestNote);
         ++note)
        if (files.contains(keyMap.objectFor(note)))
            notes.push_back(note);
    auto stored = keyMap;
    const auto bytesOf = [&](int note) -> const Bytes& { return files.at(keyMap.objectFor(note)); };
    const auto fileOf = [&](int note) {
        return folder.getChildFile(fromUtf8(stored.objectFor(note)));
    };
    // Skip a name whose file has other content, damaged or written by somebody else.
    const auto isTaken = [&](int note) {
        return fileOf(note).exists() && !holds(fileOf(note), bytesOf(note));
    };
    do
        stored.object = std::string(presetObjectFolder) + "/" + fileStem(keyMap).toStdString() +
                        "-" +
                        juce::String::toHexString(static_cast<juce::int64>(hash++)).toStdString() +
                        (isOne ? ".modal" : "/{note}.modal");
    while (std::ranges::any_of(notes, isTaken));
    for (const int note : notes) {
        if (holds(fileOf(note), bytesOf(note)))
            continue;
        if (auto written = writeWhole(fileOf(note), bytesOf(note)); !written)
            return tl::unexpected(written.error());
    }
    return stored;
}

} // namespace

Result<KeyMap>
writePresetObjects(const KeyMap& keyMap, const Instrument& instrument, const juce::File& folder) {
    const auto foreign = foreignObjects(instrument);
    if (keyMap.kind != KeyMapKind::kit)
        return writeObjects(keyMap, foreign, folder);
    std::vector parts(keyMap.parts.begin(), keyMap.parts.end());
    for (auto& part : parts) {
        auto written = writeObjects(part.keyMap, foreign, folder);
        if (!written)
            return tl::unexpected(written.error());
        part.keyMap = std::move(*written);
    }
    return kitOf(std::move(parts));
}

KeyMap withSceneBeside(KeyMap keyMap, const juce::File& presetFile) {
    if (keyMap.kind == KeyMapKind::scene && findFactoryScene(keyMap.object) == nullptr)
        if (auto name = nameBeside(sceneFileNamed(keyMap.object), pathOf(presetFile)))
            keyMap.object = std::move(*name);
    return keyMap;
}

Result<PresetInstrument> buildPresetInstrument(const KeyMap& keyMap, const juce::File& presetFile) {
    return withinMemory([&] { return buildFound(keyMap, presetFile); });
}

} // namespace idiophone
