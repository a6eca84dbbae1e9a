#include "Instrument/SilencedModes.h"

#include <algorithm>
#include <set>

namespace idiophone {
namespace {

/// Returns [M] flags: 1 for the modes of the set, or with `others` for all other modes.
std::vector<std::uint8_t>
flags(const std::set<std::int32_t>& modes, std::size_t count, bool others) {
    std::vector<std::uint8_t> result(count, others ? 1 : 0);
    for (const std::int32_t mode : modes)
        if (static_cast<std::size_t>(mode) < count)
            result[static_cast<std::size_t>(mode)] = others ? 0 : 1;
    return result;
}

} // namespace

std::string modeSetKey(const Instrument& instrument, std::size_t slot) {
    const auto& map = instrument.keyMap();
    const auto slots = instrument.slots();
    if (map.kind == KeyMapKind::bars)
        for (int note = map.lowestNote; note <= map.highestNote; ++note)
            if (instrument.hasOwn(note) &&
                slots[static_cast<std::size_t>(instrument.key(note).slot)].object ==
                    slots[slot].object)
                return std::to_string(note);
    if (map.kind == KeyMapKind::scene)
        return slots[slot].object->name;
    if (map.kind == KeyMapKind::kit)
        return instrument.objectName(slot);
    return "all";
}

SilencedModes
silencedModes(const Instrument& instrument, const ModeSet& muted, const ModeSet& heardAlone) {
    SilencedModes result;
    if (muted.empty() && heardAlone.empty())
        return result;
    std::set<const ModalObject*> seen;
    const auto slots = instrument.slots();
    for (std::size_t slot = 0; slot < slots.size(); ++slot) {
        const ModalObject* object = slots[slot].object.get();
        if (!seen.insert(object).second)
            continue;
        const auto name = modeSetKey(instrument, slot);
        const auto& alone = heardAlone.of(name);
        const bool isAlone = std::ranges::any_of(alone, [&](std::int32_t mode) {
            return static_cast<std::size_t>(mode) < object->modeCount();
        });
        const auto& named = isAlone ? alone : muted.of(name);
        if (!named.empty())
            result.objects.push_back(
                {.object = object, .isSilenced = flags(named, object->modeCount(), isAlone)});
    }
    return result;
}

} // namespace idiophone
