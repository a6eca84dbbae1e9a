#include "Instrument/Instrument.h"

#include "Instrument/KeyBuilder.h"
#include "Object/OneLine.h"

#include <algorithm>
#include <atomic>
#include <bitset>
#include <cmath>
#include <iterator>
#include <numeric>

namespace idiophone {
namespace {

std::uint64_t nextSerialNumber() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

} // namespace

Result<void> boundedSlots(std::span<const SynthesiserSlot> slots,
                          const std::string& ofWhat,
                          const char* played) {
    if (slots.size() > maximumSlots)
        return failure(ofWhat + " has " + std::to_string(slots.size()) + " " + played +
                       ", more than the " + std::to_string(maximumSlots) + " that can be played");
    const std::size_t modes = modesOf(slots);
    if (modes > maximumModesOfSlots)
        return failure(ofWhat + " has " + std::to_string(modes) + " modes on all " + played +
                       " together, more than the " + std::to_string(maximumModesOfSlots) +
                       " that can be played");
    return {};
}

Instrument::Instrument(KeyMap keyMap)
    : serial(nextSerialNumber()), map(std::move(keyMap)), keys(128) {
    std::iota(firstKeys.begin(), firstKeys.end(), std::size_t{0});
}

Result<std::shared_ptr<const Instrument>> Instrument::build(const KeyMap& keyMap,
                                                            ObjectSource& objects) {
    if (keyMap.lowestNote < 0 || keyMap.highestNote > 127 ||
        keyMap.lowestNote > keyMap.highestNote || keyMap.strikePath.empty())
        return failure("the key map's notes are not between 0 and 127, or it has no strike path");
    if (keyMap.kind == KeyMapKind::scene)
        return failure("a scene is not built of keys");
    auto instrument = std::shared_ptr<Instrument>(new Instrument(keyMap));
    const auto added = keyMap.kind == KeyMapKind::kit ? instrument->addParts(objects)
                                                      : instrument->addMap(objects);
    if (!added)
        return tl::unexpected(added.error());
    instrument->describeSlots();
    return std::shared_ptr<const Instrument>(instrument);
}

Result<void> Instrument::addMap(ObjectSource& objects) {
    auto built = buildKeys(map, objects);
    if (!built)
        return tl::unexpected(built.error());
    if (auto bounded = boundedSlots(built->slots, inQuotes(map.object)); !bounded)
        return bounded;
    addResizedKeys(*built, map, std::bitset<128>().set(), maximumModesOfResizedKeys);
    synthesiserSlots = std::move(built->slots);
    slotNames = std::move(built->names);
    std::ranges::move(built->keys, keys.begin());
    return {};
}

Result<void> Instrument::addParts(ObjectSource& objects) {
    if (auto valid = validKit(map); !valid)
        return failure("the kit's parts " + valid.error().message);
    std::array<std::vector<Key>, 128> keysOfNotes;
    std::bitset<128> free;
    for (std::size_t note = 0; note < free.size(); ++note)
        free[note] = std::ranges::none_of(map.parts, [&](const KitPart& part) {
            return part.keyMap.lowestNote <= static_cast<int>(note) &&
                   static_cast<int>(note) <= part.keyMap.highestNote;
        });
    for (const auto& part : map.parts) {
        auto built = buildKeys(part.keyMap, objects);
        if (!built)
            return tl::unexpected(built.error());
        addResizedKeys(*built, part.keyMap, free, maximumModesOfSlots);
        const auto firstSlot = static_cast<int>(synthesiserSlots.size());
        for (std::size_t note = 0; note < keysOfNotes.size(); ++note)
            if (auto key = built->keys[note]; key.slot >= 0) {
                key.slot += firstSlot;
                key.mallet.gain *= std::pow(10, part.levelDb / 20);
                key.part = &part;
                free[note] = false;
                keysOfNotes[note].push_back(std::move(key));
            }
        std::ranges::move(built->slots, std::back_inserter(synthesiserSlots));
        std::ranges::move(built->names, std::back_inserter(slotNames));
        if (auto bounded = boundedSlots(synthesiserSlots, "the kit"); !bounded)
            return bounded;
    }
    keys.clear();
    for (std::size_t note = 0; note < keysOfNotes.size(); ++note) {
        firstKeys[note] = keys.size();
        if (keysOfNotes[note].empty())
            keys.emplace_back();
        std::ranges::move(keysOfNotes[note], std::back_inserter(keys));
    }
    firstKeys.back() = keys.size();
    return {};
}

std::shared_ptr<const Instrument> Instrument::onStage(KeyMap keyMap,
                                                      std::vector<SynthesiserSlot> slots,
                                                      const std::array<int, 128>& slotOfKey,
                                                      std::shared_ptr<const Stage> stage) {
    auto instrument = std::shared_ptr<Instrument>(new Instrument(std::move(keyMap)));
    instrument->synthesiserSlots = std::move(slots);
    instrument->ownStage = std::move(stage);
    instrument->slotNames.resize(instrument->synthesiserSlots.size());
    StripsOfObjects strips(instrument->map);
    for (std::size_t note = 0; note < slotOfKey.size(); ++note) {
        const int slot = slotOfKey[note];
        if (slot < 0)
            continue;
        const auto& struck = instrument->synthesiserSlots[static_cast<std::size_t>(slot)];
        instrument->keys[note] = {.slot = slot,
                                  .strip = strips.of(*struck.object),
                                  .along = instrument->map.strikePlace(static_cast<int>(note))};
    }
    instrument->describeSlots();
    return instrument;
}

void Instrument::describeSlots() {
    mallets.resize(synthesiserSlots.size());
    parts.resize(synthesiserSlots.size(), nullptr);
    std::vector<int> keysOfSlots(synthesiserSlots.size(), 0);
    followKeys.assign(synthesiserSlots.size(), true);
    for (const Key& key : keys) {
        if (key.slot < 0)
            continue;
        const auto slot = static_cast<std::size_t>(key.slot);
        const auto kind = key.part == nullptr ? map.kind : key.part->keyMap.kind;
        parts[slot] = key.part;
        followKeys[slot] = ++keysOfSlots[slot] == 1 && kind != KeyMapKind::zones;
        if (kind != KeyMapKind::zones) // in zones all keys share the slot
            mallets[slot] = key.mallet;
    }
    for (const auto& slot : synthesiserSlots)
        lowestModesOfSlots.emplace_back(*slot.object);
}

bool Instrument::has(std::size_t slot, const StrikePoint& point) const {
    if (slot >= synthesiserSlots.size())
        return false;
    const auto rows = synthesiserSlots[slot].object->shapeVertexCount();
    return std::ranges::all_of(point.shapeRows, [rows](std::int32_t row) {
        return row >= 0 && static_cast<std::size_t>(row) < rows;
    });
}

bool Instrument::keysHaveObjects() const {
    return map.kind != KeyMapKind::zones && std::ranges::all_of(keys, [&](const Key& key) {
               return key.slot < 0 || followsKey(static_cast<std::size_t>(key.slot));
           });
}

} // namespace idiophone
