#include "Instrument/Instrument.h"

#include "Object/OneLine.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace idiophone {
namespace {

double midiNoteHz(double note) {
    return 440 * std::exp2((note - 69) / 12);
}

/// The damped frequency of the lowest mode.
double lowestModeHz(const ModalObject& object) {
    const double eigenvalue = object.eigenvalues.front();
    const double decay = object.decayPerSecond(0);
    return std::sqrt(std::max(eigenvalue - decay * decay, 1.0)) / (2 * std::numbers::pi);
}

std::uint64_t nextSerialNumber() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

} // namespace

Result<void> boundedSlots(std::span<const SynthesiserSlot> slots,
                          const std::string& ofWhat,
                          const char* played) {
    if (slots.size() > mostSlots)
        return failure(ofWhat + " has " + std::to_string(slots.size()) + " " + played +
                       ", more than the " + std::to_string(mostSlots) + " that can be played");
    std::size_t modes = 0;
    for (const auto& slot : slots)
        modes += slot.object->modeCount();
    if (modes > mostModesOfSlots)
        return failure(ofWhat + " has " + std::to_string(modes) + " modes on all " + played +
                       " together, more than the " + std::to_string(mostModesOfSlots) +
                       " that can be played");
    return {};
}

Instrument::Instrument(KeyMap keyMap) : serial(nextSerialNumber()), map(std::move(keyMap)) {}

Result<std::shared_ptr<const Instrument>> Instrument::build(const KeyMap& keyMap,
                                                            ObjectLibrary& library) {
    if (keyMap.lowestNote < 0 || keyMap.highestNote > 127 ||
        keyMap.lowestNote > keyMap.highestNote || keyMap.strikePath.empty())
        return failure("the key map's notes are not between 0 and 127, or it has no strike path");
    if (keyMap.kind == KeyMapKind::scene)
        return failure("a scene is not built of keys");
    auto instrument = std::shared_ptr<Instrument>(new Instrument(keyMap));
    const auto built = keyMap.kind == KeyMapKind::bars ? instrument->buildBars(library)
                                                       : instrument->buildSingleObject(library);
    if (!built)
        return tl::unexpected(built.error());
    return boundedSlots(instrument->slots(), inQuotes(keyMap.object)).map([&] {
        return std::shared_ptr<const Instrument>(instrument);
    });
}

std::shared_ptr<const Instrument> Instrument::onStage(KeyMap keyMap,
                                                      std::vector<SynthesiserSlot> slots,
                                                      const std::array<int, 128>& slotOfKey,
                                                      std::shared_ptr<const Stage> stage) {
    auto instrument = std::shared_ptr<Instrument>(new Instrument(std::move(keyMap)));
    instrument->synthesiserSlots = std::move(slots);
    instrument->ownStage = std::move(stage);
    std::map<int, int> stripOfSlot;
    for (std::size_t note = 0; note < slotOfKey.size(); ++note) {
        const int slot = slotOfKey[note];
        if (slot < 0)
            continue;
        const auto [strip, isNew] =
            stripOfSlot.try_emplace(slot, static_cast<int>(instrument->strips.size()));
        if (isNew)
            instrument->strips.push_back(
                strikeStrip(*instrument->synthesiserSlots[static_cast<std::size_t>(slot)].object,
                            instrument->map));
        instrument->keys[note] = {.slot = slot,
                                  .strip = strip->second,
                                  .along = instrument->map.strikeAt};
    }
    return instrument;
}

bool Instrument::keysHaveObjects() const {
    if (map.kind == KeyMapKind::zones)
        return false;
    std::set<int> played;
    return std::ranges::all_of(
        keys, [&](const Key& key) { return key.slot < 0 || played.insert(key.slot).second; });
}

Result<void> Instrument::buildBars(ObjectLibrary& library) {
    std::map<const ModalObject*, int> stripOfObject; // one may be on many keys, and is large
    const double middleHz = midiNoteHz((map.lowestNote + map.highestNote) / 2.0);
    for (int note = map.lowestNote; note <= map.highestNote; ++note) {
        const double pitchRatio = midiNoteHz(note) / middleHz;
        auto object = library.find(map.objectFor(note));
        if (!object)
            return tl::unexpected(object.error());
        const auto [strip, isNew] =
            stripOfObject.try_emplace(object->get(), static_cast<int>(strips.size()));
        if (isNew)
            strips.push_back(strikeStrip(**object, map));
        keys[static_cast<std::size_t>(note)] = {.slot = static_cast<int>(synthesiserSlots.size()),
                                                .strip = strip->second,
                                                .along = map.strikeAt,
                                                .mallet = {.pitchRatio = pitchRatio}};
        synthesiserSlots.push_back({.object = std::move(*object), .sizeRatio = 1});
    }
    return {};
}

Result<void> Instrument::buildSingleObject(ObjectLibrary& library) {
    auto object = library.find(map.object);
    if (!object)
        return tl::unexpected(object.error());
    strips.push_back(strikeStrip(**object, map));

    const double referenceHz =
        map.referenceNote >= 0 ? midiNoteHz(map.referenceNote) : lowestModeHz(**object);
    const int range = map.highestNote - map.lowestNote;
    for (int note = map.lowestNote; note <= map.highestNote; ++note) {
        auto& key = keys[static_cast<std::size_t>(note)];
        if (map.kind == KeyMapKind::zones) {
            key = {.slot = 0,
                   .strip = 0,
                   .along = range > 0 ? static_cast<double>(note - map.lowestNote) / range
                                      : map.strikeAt};
            continue;
        }
        // The mallet is scaled with the object: every key is the same event at another size, where
        // one mallet for all would make small objects louder by the cube of their pitch.
        const double sizeRatio = referenceHz / midiNoteHz(note);
        key = {.slot = static_cast<int>(synthesiserSlots.size()),
               .strip = 0,
               .along = map.strikeAt,
               .mallet = {.scale = sizeRatio}};
        synthesiserSlots.push_back({.object = *object, .sizeRatio = sizeRatio});
    }
    if (map.kind == KeyMapKind::zones)
        synthesiserSlots.push_back({.object = *object, .sizeRatio = 1});
    return {};
}

} // namespace idiophone
