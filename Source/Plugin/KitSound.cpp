#include "Plugin/KitSound.h"

#include "Editor/KitView.h"
#include "Editor/ModeText.h"
#include "Instrument/FactoryContent.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/SettingsOfParameters.h"
#include "Instrument/SilencedModes.h"
#include "Instrument/StartingLevel.h"
#include "Plugin/FactoryPrograms.h"
#include "Plugin/ImportedSound.h"
#include "Plugin/WithinMemory.h"

#include <algorithm>
#include <iterator>

namespace idiophone {
namespace {

using Object = std::shared_ptr<const ModalObject>;

KitPart partOn(int midiNote, const std::string& objectName) {
    return {.keyMap = {.kind = KeyMapKind::zones,
                       .lowestNote = midiNote,
                       .highestNote = midiNote,
                       .object = objectName}};
}

/// Returns the parts of a kit, or another map as the only part.
std::vector<KitPart> partsOf(const KeyMap& map) {
    if (map.kind != KeyMapKind::kit)
        return {{.keyMap = map}};
    return {map.parts.begin(), map.parts.end()};
}

bool hasObject(const Instrument& instrument, const std::string& name) {
    for (std::size_t slot = 0; slot < instrument.slots().size(); ++slot)
        if (instrument.objectName(slot) == name)
            return true;
    return factoryObject(name).has_value();
}

/// Returns the muted modes under the names that they have in a kit.
ModeSet mutedInKit(const ModeSet& muted, const Instrument& instrument) {
    ModeSet result;
    for (std::size_t slot = 0; slot < instrument.slots().size(); ++slot)
        for (const auto mode : muted.of(modeSetKey(instrument, slot)))
            result.set(instrument.objectName(slot), mode, true);
    return result;
}

/// Builds an instrument of the objects of another one, and of one more unless it is null.
Result<std::shared_ptr<const Instrument>> built(const Instrument& before,
                                                const KeyMap& map,
                                                const Object& added = nullptr,
                                                const std::string& addedName = {}) {
    ObjectLibrary library(ObjectLibrary::shared());
    const auto slots = before.slots();
    for (std::size_t slot = 0; slot < slots.size(); ++slot)
        library.add(before.objectName(slot), slots[slot].object);
    if (added != nullptr)
        library.add(addedName, added);
    return Instrument::build(map, library).and_then(fitForState);
}

/// Returns the sound as a kit of these parts.
Result<Sound> withParts(const Sound& before,
                        std::vector<KitPart> parts,
                        const Object& added = nullptr,
                        const std::string& addedName = {}) {
    return canBeKit(before).and_then([&]() -> Result<Sound> {
        const auto kit = kitOf(std::move(parts));
        const auto instrument =
            withinMemory([&] { return built(*before.instrument, kit, added, addedName); });
        if (!instrument)
            return tl::unexpected(instrument.error());
        auto sound = before;
        sound.instrument = *instrument;
        sound.preset.keyMap = kit;
        sound.preset.mutedModes = mutedInKit(before.preset.mutedModes, *before.instrument);
        if (factoryProgram(sound.presetId) >= 0)
            sound.presetId.clear(); // it is that preset no more
        return sound;
    });
}

/// Returns the gain at which an object is as loud in the sound as factory presets are. The part is
/// no keyboard of bars.
Result<double>
levelOf(const KitPart& part, const Object& object, const Sound& sound, double sampleRateHz) {
    return buildSingleObject(part.keyMap, object).map([&](const auto& alone) {
        const auto values = withPart(sound.parameters, part);
        const Phrase phrase(alone, sound.preset.surface, sampleRateHz);
        return startingLevel(phrase, values) - values[ParameterId::level];
    });
}

double withinRange(double levelDb) {
    return std::clamp(levelDb, -KitView::maximumLevelDb, KitView::maximumLevelDb);
}

} // namespace

Result<void> canBeKit(const Sound& sound) {
    if (sound.instrument == nullptr || sound.instrument->stage() != nullptr)
        return failure("the keys play a scene");
    if (sound.missing != nullptr)
        return failure("a steel ring plays in the place of " + sound.missing->first +
                       ", which is missing");
    return {};
}

Result<Sound> asKit(const Sound& before) {
    return withParts(before, partsOf(before.preset.keyMap));
}

Result<Sound> withChangedPart(const Sound& before, std::size_t index, const KitPart& part) {
    const auto& map = part.keyMap;
    if (map.kind == KeyMapKind::bars &&
        !hasObject(*before.instrument, map.objectFor(map.lowestNote)))
        return failure("it has no bar for " + noteName(map.lowestNote).toStdString());
    auto parts = partsOf(before.preset.keyMap);
    parts[index] = part;
    return withParts(before, std::move(parts));
}

Result<Sound> withoutPart(const Sound& before, std::size_t index) {
    auto parts = partsOf(before.preset.keyMap);
    if (parts.size() == 1)
        return failure("a kit has at least one part");
    parts.erase(std::next(parts.begin(), static_cast<std::ptrdiff_t>(index)));
    return withParts(before, std::move(parts));
}

Result<Sound> withObjectOnKey(const Sound& before,
                              int midiNote,
                              const Object& object,
                              const std::string& objectName,
                              double sampleRateHz) {
    if (const auto possible = canBeKit(before); !possible)
        return tl::unexpected(possible.error());
    auto part = partOn(midiNote, objectName);
    const auto level = levelOf(part, object, before, sampleRateHz);
    if (!level)
        return tl::unexpected(level.error());
    part.levelDb = withinRange(*level);
    auto parts = partsOf(before.preset.keyMap);
    if (before.preset.keyMap.kind == KeyMapKind::kit)
        std::erase_if(parts, [midiNote](const KitPart& other) {
            return other.keyMap.lowestNote == midiNote && other.keyMap.highestNote == midiNote;
        });
    parts.push_back(part);
    if (!validKit(kitOf(parts)))
        return failure("two objects play it already");
    return withParts(before, std::move(parts), object, objectName);
}

Result<Sound> withWholeObject(const Sound& before,
                              const Object& preview,
                              const Object& whole,
                              const std::string& wholeName,
                              double sampleRateHz) {
    const auto slot = slotOf(before.instrument, *preview);
    if (!slot)
        return before;
    const auto& previewName = before.instrument->objectName(*slot);
    auto map = before.preset.keyMap;
    if (map.kind != KeyMapKind::kit) {
        map.object = wholeName;
        return built(*before.instrument, map, whole, wholeName).map([&](auto instrument) {
            auto sound = before;
            sound.instrument = std::move(instrument);
            sound.preset.keyMap = map;
            return sound;
        });
    }
    auto parts = partsOf(map);
    for (auto& part : parts) {
        if (part.keyMap.object != previewName)
            continue;
        const auto former = levelOf(part, preview, before, sampleRateHz);
        part.keyMap.object = wholeName;
        const auto level = levelOf(part, whole, before, sampleRateHz);
        if (!former || !level)
            return tl::unexpected((former ? level : former).error());
        part.levelDb = withinRange(part.levelDb + *level - *former);
    }
    return withParts(before, std::move(parts), whole, wholeName);
}

KeyMap onKeys(const KeyMap& map, int lowestNote, int highestNote) {
    auto moved = map;
    moved.lowestNote = moved.resizedFrom = lowestNote;
    moved.highestNote = moved.resizedTo = highestNote;
    if (map.voicingDb.empty() && map.strikeAt.size() == 1)
        return moved;
    moved.voicingDb.clear();
    if (map.kind != KeyMapKind::zones)
        moved.strikeAt.clear();
    for (int note = lowestNote; note <= highestNote; ++note) {
        const int nearest = std::clamp(note, map.lowestNote, map.highestNote);
        const auto place = static_cast<std::size_t>(nearest - map.lowestNote);
        if (!map.voicingDb.empty())
            moved.voicingDb.push_back(place < map.voicingDb.size() ? map.voicingDb[place] : 0);
        if (map.kind != KeyMapKind::zones)
            moved.strikeAt.push_back(map.strikePlace(nearest));
    }
    return moved;
}

} // namespace idiophone
