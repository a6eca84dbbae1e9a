#include "Plugin/KitSound.h"

#include "Instrument/SilencedModes.h"
#include "Instrument/StartingLevel.h"
#include "Plugin/WithinMemory.h"

#include <algorithm>

namespace idiophone {
namespace {

KitPart partOn(int midiNote, const std::string& objectName) {
    return {.keyMap = {.kind = KeyMapKind::zones,
                       .lowestNote = midiNote,
                       .highestNote = midiNote,
                       .object = objectName}};
}

/// Returns the map as parts of a kit, without those for this key alone.
std::vector<KitPart> partsBeside(const KeyMap& map, int midiNote) {
    std::vector<KitPart> parts;
    if (map.kind != KeyMapKind::kit)
        parts.push_back({.keyMap = map});
    for (const auto& part : map.parts)
        if (part.keyMap.lowestNote != midiNote || part.keyMap.highestNote != midiNote)
            parts.push_back(part);
    return parts;
}

/// Returns the muted modes under the names that they have in a kit.
ModeSet mutedInKit(const ModeSet& muted, const Instrument& instrument) {
    ModeSet result;
    for (std::size_t slot = 0; slot < instrument.slots().size(); ++slot)
        for (const auto mode : muted.of(modeSetKey(instrument, slot)))
            result.set(instrument.objectName(slot), mode, true);
    return result;
}

Result<std::shared_ptr<const Instrument>> built(const Instrument& before,
                                                const KeyMap& kit,
                                                const std::string& objectName,
                                                const std::shared_ptr<const ModalObject>& object) {
    ObjectLibrary library(ObjectLibrary::shared());
    const auto slots = before.slots();
    for (std::size_t slot = 0; slot < slots.size(); ++slot)
        library.add(before.objectName(slot), slots[slot].object);
    library.add(objectName, object);
    return Instrument::build(kit, library).and_then(fitForState);
}

} // namespace

Result<Sound> withObjectOnKey(const Sound& before,
                              int midiNote,
                              const std::shared_ptr<const ModalObject>& object,
                              const std::string& objectName,
                              double sampleRateHz) {
    if (before.instrument == nullptr || before.instrument->stage() != nullptr)
        return failure("the keys play a scene");
    if (before.missing != nullptr)
        return failure("a steel ring plays in the place of " + before.missing->first +
                       ", which is missing");
    auto part = partOn(midiNote, objectName);
    return withinMemory([&]() -> Result<Sound> {
        const auto alone = buildSingleObject(part.keyMap, object);
        if (!alone)
            return tl::unexpected(alone.error());
        const auto& values = before.parameters;
        const Phrase phrase(*alone, before.preset.surface, sampleRateHz);
        part.levelDb =
            std::clamp(startingLevel(phrase, values) - values[ParameterId::level], -40.0, 40.0);
        auto parts = partsBeside(before.preset.keyMap, midiNote);
        parts.push_back(part);
        const auto kit = kitOf(std::move(parts));
        if (const auto valid = validKit(kit); !valid)
            return failure("two objects play it already");
        const auto instrument = built(*before.instrument, kit, objectName, object);
        if (!instrument)
            return tl::unexpected(instrument.error());
        auto sound = before;
        sound.instrument = *instrument;
        sound.preset.keyMap = kit;
        sound.preset.mutedModes = mutedInKit(before.preset.mutedModes, *before.instrument);
        return sound;
    });
}

} // namespace idiophone
