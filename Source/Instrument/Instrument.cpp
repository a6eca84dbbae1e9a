#include "Instrument/Instrument.h"

#include "Object/OneLine.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

namespace idiophone {
namespace {

double midiNoteHz(double note) {
    return 440 * std::exp2((note - 69) / 12);
}

/// Returns the damped frequency of a mode, above 0.
double modeHz(const ModalObject& object, std::size_t mode) {
    const double decay = object.decayPerSecond(mode);
    return std::sqrt(std::max(object.eigenvalues[mode] - decay * decay, 1.0)) /
           (2 * std::numbers::pi);
}

/// Returns the power-weighted mean of the modes that bar and tube share, which is the pitch that is
/// heard. Returns nothing if damping leaves the mode no pitch (stiffnessSoundingAt).
std::optional<PitchMode> pitchMode(const ModalObject& object, std::size_t mode, double sizeRatio) {
    PitchMode mean{.damping = {.scale = 0}};
    double weights = 0, decay = 0;
    for (const std::size_t part : {mode, sharingPartner(object, mode).value_or(mode)}) {
        if (weights > 0 && part == mode)
            continue;
        const auto weight =
            object.gains.empty() ? 1.0 : static_cast<double>(std::norm(object.gains[part]));
        const auto add = [&, share = weight / (weights + weight)](double& sum, double value) {
            sum += share * (value - sum);
        };
        const auto damping = object.damping(part);
        add(mean.hz, modeHz(object, part));
        add(decay, object.decayPerSecond(part));
        add(mean.bending, object.hasLiveThickness() ? object.bending[part] : 0);
        add(mean.damping.scale, damping.scale);
        add(mean.damping.extraPerSecond, damping.extraPerSecond);
        weights += weight;
    }
    mean.eigenvalue = std::pow(2 * std::numbers::pi * mean.hz, 2) + decay * decay;
    if (2 * decay * decay > mean.eigenvalue)
        return std::nullopt;
    mean.hz /= sizeRatio;
    return mean;
}

/// Returns the mode nearest in pitch to a frequency, if it is less than half a semitone off.
std::optional<std::size_t> modeNear(const ModalObject& object, double hz) {
    std::optional<std::size_t> nearest;
    double miss = 0.5 / 12;
    for (std::size_t mode = 0; mode < object.modeCount(); ++mode)
        if (const double octaves = std::abs(std::log2(modeHz(object, mode) / hz)); octaves < miss) {
            miss = octaves;
            nearest = mode;
        }
    return nearest;
}

/// Returns the mode that gives a bar its pitch: the one at its key, or the one an octave above,
/// because the strike note of tubular bells lies an octave below a mode. A bar in another tuning
/// takes its lowest mode.
std::size_t pitchModeOfBar(const ModalObject& bar, int midiNote) {
    const double hz = midiNoteHz(midiNote);
    if (const auto mode = modeNear(bar, hz))
        return *mode;
    return modeNear(bar, 2 * hz).value_or(0);
}

std::size_t modesOf(std::span<const SynthesiserSlot> slots) {
    std::size_t modes = 0;
    for (const auto& slot : slots)
        modes += slot.object->modeCount();
    return modes;
}

/// Returns the nearest key with an object of its own, the lower one of two at equal distance. One
/// must exist.
int nearestOwn(const std::array<Key, 128>& keys, int note) {
    for (int distance = 0;; ++distance)
        for (const int near : {note - distance, note + distance})
            if (near >= 0 && near < 128 && keys[static_cast<std::size_t>(near)].slot >= 0)
                return near;
}

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
    if (auto bounded = boundedSlots(instrument->slots(), inQuotes(keyMap.object)); !bounded)
        return tl::unexpected(bounded.error());
    instrument->voice();
    if (keyMap.kind != KeyMapKind::zones)
        instrument->addResizedKeys();
    instrument->describeSlots();
    return std::shared_ptr<const Instrument>(instrument);
}

std::shared_ptr<const Instrument> Instrument::onStage(KeyMap keyMap,
                                                      std::vector<SynthesiserSlot> slots,
                                                      const std::array<int, 128>& slotOfKey,
                                                      std::shared_ptr<const Stage> stage) {
    auto instrument = std::shared_ptr<Instrument>(new Instrument(std::move(keyMap)));
    instrument->synthesiserSlots = std::move(slots);
    instrument->ownStage = std::move(stage);
    for (std::size_t note = 0; note < slotOfKey.size(); ++note) {
        const int slot = slotOfKey[note];
        if (slot < 0)
            continue;
        const auto& struck = instrument->synthesiserSlots[static_cast<std::size_t>(slot)];
        instrument->keys[note] = {.slot = slot,
                                  .strip = instrument->stripOf(*struck.object),
                                  .along = instrument->map.strikePlace(static_cast<int>(note))};
    }
    instrument->describeSlots();
    return instrument;
}

/// Makes the strip if the object is new: several keys may share a large one.
std::shared_ptr<const StrikeStrip> Instrument::stripOf(const ModalObject& object) {
    auto& strip = strips[&object];
    if (strip == nullptr)
        strip = std::make_shared<const StrikeStrip>(strikeStrip(object, map));
    return strip;
}

void Instrument::describeSlots() {
    mallets.resize(synthesiserSlots.size());
    if (map.kind != KeyMapKind::zones) // in zones all keys share the slot
        for (const Key& key : keys)
            if (key.slot >= 0)
                mallets[static_cast<std::size_t>(key.slot)] = key.mallet;
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
    if (map.kind == KeyMapKind::zones)
        return false;
    std::set<int> played;
    return std::ranges::all_of(
        keys, [&](const Key& key) { return key.slot < 0 || played.insert(key.slot).second; });
}

Result<void> Instrument::buildBars(ObjectLibrary& library) {
    const double middleHz = midiNoteHz((map.lowestNote + map.highestNote) / 2.0);
    for (int note = map.lowestNote; note <= map.highestNote; ++note) {
        const double pitchRatio = midiNoteHz(note) / middleHz;
        const auto name = map.objectFor(note);
        if (note > map.lowestNote && !library.has(name))
            continue;
        auto object = library.find(name);
        if (!object)
            return tl::unexpected(object.error());
        keys[static_cast<std::size_t>(note)] = {.slot = static_cast<int>(synthesiserSlots.size()),
                                                .strip = stripOf(**object),
                                                .along = map.strikePlace(note),
                                                .mallet = {.pitchRatio = pitchRatio}};
        const auto pitch = pitchMode(**object, pitchModeOfBar(**object, note), 1);
        synthesiserSlots.push_back({.object = std::move(*object), .sizeRatio = 1, .pitch = pitch});
    }
    return {};
}

void Instrument::voice() {
    auto note = static_cast<std::size_t>(map.lowestNote);
    for (const double db : map.voicingDb)
        if (note < keys.size())
            keys[note++].mallet.gain = std::pow(10, db / 20);
}

/// Lets keys without an object play the nearest of the preset's own keys, resized to their pitch.
void Instrument::addResizedKeys() {
    const auto own = keys;
    auto resized = synthesiserSlots;
    auto played = own;
    for (int note = std::min(map.resizedFrom, map.lowestNote);
         note <= std::max(map.resizedTo, map.highestNote); ++note) {
        const bool isWithin = note >= map.lowestNote && note <= map.highestNote;
        const bool isBeside = note >= map.resizedFrom && note <= map.resizedTo;
        if (own[static_cast<std::size_t>(note)].slot >= 0 || !(isWithin || isBeside))
            continue;
        const int nearest = nearestOwn(own, note);
        const double ratio = std::exp2((nearest - note) / 12.0);
        auto& key = played[static_cast<std::size_t>(note)];
        key = own[static_cast<std::size_t>(nearest)];
        auto slot = resized[static_cast<std::size_t>(key.slot)];
        slot.sizeRatio *= ratio;
        if (slot.pitch)
            slot.pitch->hz /= ratio;
        key.slot = static_cast<int>(resized.size());
        key.mallet.scale *= ratio;
        key.isOwn = false;
        resized.push_back(std::move(slot));
    }
    if (modesOf(resized) > maximumModesOfResizedKeys)
        return;
    keys = played;
    synthesiserSlots = std::move(resized);
}

Result<void> Instrument::buildSingleObject(ObjectLibrary& library) {
    auto object = library.find(map.object);
    if (!object)
        return tl::unexpected(object.error());
    const double referenceHz =
        map.referenceNote >= 0 ? midiNoteHz(map.referenceNote) : modeHz(**object, 0);
    // A fork's prongs swing to one side in a lower mode than that of its pitch.
    const std::size_t pitched = modeNear(**object, referenceHz).value_or(0);
    for (int note = map.lowestNote; note <= map.highestNote; ++note) {
        auto& key = keys[static_cast<std::size_t>(note)];
        if (map.kind == KeyMapKind::zones) {
            key = {.slot = 0, .strip = stripOf(**object), .along = map.strikePlace(note)};
            continue;
        }
        // Scale the mallet with the object, so that every key is the same event at another size.
        // With one mallet for all, small objects would be louder by the cube of their pitch.
        const double sizeRatio = referenceHz / midiNoteHz(note);
        key = {.slot = static_cast<int>(synthesiserSlots.size()),
               .strip = stripOf(**object),
               .along = map.strikePlace(note),
               .mallet = {.scale = sizeRatio}};
        synthesiserSlots.push_back({.object = *object,
                                    .sizeRatio = sizeRatio,
                                    .pitch = pitchMode(**object, pitched, sizeRatio)});
    }
    if (map.kind == KeyMapKind::zones)
        synthesiserSlots.push_back({.object = *object, .sizeRatio = 1});
    return {};
}

} // namespace idiophone
