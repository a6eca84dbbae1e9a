#include "Instrument/KeyBuilder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

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

/// Returns the nearest key with an object of its own, the lower one of two at equal distance. One
/// must exist.
int nearestOwn(const std::array<Key, 128>& keys, int note) {
    for (int distance = 0;; ++distance)
        for (const int near : {note - distance, note + distance})
            if (near >= 0 && near < 128 && keys[static_cast<std::size_t>(near)].slot >= 0)
                return near;
}

Result<BuiltKeys> buildBars(const KeyMap& map, ObjectSource& objects) {
    BuiltKeys built;
    StripsOfObjects strips(map);
    const double middleHz = midiNoteHz((map.lowestNote + map.highestNote) / 2.0);
    for (int note = map.lowestNote; note <= map.highestNote; ++note) {
        const double pitchRatio = midiNoteHz(note) / middleHz;
        const auto name = map.objectFor(note);
        if (note > map.lowestNote && !objects.has(name))
            continue;
        auto object = objects.find(name);
        if (!object)
            return tl::unexpected(object.error());
        built.keys[static_cast<std::size_t>(note)] = {.slot = static_cast<int>(built.slots.size()),
                                                      .strip = strips.of(**object),
                                                      .along = map.strikePlace(note),
                                                      .mallet = {.pitchRatio = pitchRatio}};
        const auto pitch = pitchMode(**object, pitchModeOfBar(**object, note), 1);
        built.slots.push_back({.object = std::move(*object), .sizeRatio = 1, .pitch = pitch});
        built.names.push_back(name);
    }
    return built;
}

Result<BuiltKeys> buildSingleObject(const KeyMap& map, ObjectSource& objects) {
    BuiltKeys built;
    StripsOfObjects strips(map);
    auto object = objects.find(map.object);
    if (!object)
        return tl::unexpected(object.error());
    const double referenceHz =
        map.referenceNote >= 0 ? midiNoteHz(map.referenceNote) : modeHz(**object, 0);
    // A fork's prongs swing to one side in a lower mode than that of its pitch.
    const std::size_t pitched = modeNear(**object, referenceHz).value_or(0);
    for (int note = map.lowestNote; note <= map.highestNote; ++note) {
        auto& key = built.keys[static_cast<std::size_t>(note)];
        if (map.kind == KeyMapKind::zones) {
            key = {.slot = 0, .strip = strips.of(**object), .along = map.strikePlace(note)};
            continue;
        }
        // Scale the mallet with the object, so that every key is the same event at another size.
        // With one mallet for all, small objects would be louder by the cube of their pitch.
        const double sizeRatio = referenceHz / midiNoteHz(note);
        key = {.slot = static_cast<int>(built.slots.size()),
               .strip = strips.of(**object),
               .along = map.strikePlace(note),
               .mallet = {.scale = sizeRatio}};
        built.slots.push_back({.object = *object,
                               .sizeRatio = sizeRatio,
                               .pitch = pitchMode(**object, pitched, sizeRatio)});
    }
    if (map.kind == KeyMapKind::zones)
        built.slots.push_back({.object = *object, .sizeRatio = 1});
    built.names.assign(built.slots.size(), map.object);
    return built;
}

void voice(std::array<Key, 128>& keys, const KeyMap& map) {
    auto note = static_cast<std::size_t>(map.lowestNote);
    for (const double db : map.voicingDb)
        if (note < keys.size())
            keys[note++].mallet.gain = std::pow(10, db / 20);
}

} // namespace

std::shared_ptr<const StrikeStrip> StripsOfObjects::of(const ModalObject& object) {
    auto& strip = strips[&object];
    if (strip == nullptr)
        strip = std::make_shared<const StrikeStrip>(strikeStrip(object, map));
    return strip;
}

Result<BuiltKeys> buildKeys(const KeyMap& map, ObjectSource& objects) {
    return (map.kind == KeyMapKind::bars ? buildBars(map, objects)
                                         : buildSingleObject(map, objects))
        .transform([&](BuiltKeys built) {
            voice(built.keys, map);
            return built;
        });
}

void addResizedKeys(BuiltKeys& built,
                    const KeyMap& map,
                    const std::bitset<128>& free,
                    std::size_t maximumModes) {
    if (map.kind == KeyMapKind::zones)
        return;
    const auto& own = built.keys;
    auto resized = built;
    for (int note = 0; note < static_cast<int>(own.size()); ++note) {
        const bool isWithin = note >= map.lowestNote && note <= map.highestNote;
        const bool isBeside = free[static_cast<std::size_t>(note)] && note >= map.resizedFrom &&
                              note <= map.resizedTo;
        if (own[static_cast<std::size_t>(note)].slot >= 0 || !(isWithin || isBeside))
            continue;
        const int nearest = nearestOwn(own, note);
        const double ratio = std::exp2((nearest - note) / 12.0);
        auto& key = resized.keys[static_cast<std::size_t>(note)];
        key = own[static_cast<std::size_t>(nearest)];
        const auto nearestSlot = static_cast<std::size_t>(key.slot);
        auto slot = built.slots[nearestSlot];
        slot.sizeRatio *= ratio;
        if (slot.pitch)
            slot.pitch->hz /= ratio;
        key.slot = static_cast<int>(resized.slots.size());
        key.mallet.scale *= ratio;
        key.isOwn = false;
        resized.slots.push_back(std::move(slot));
        resized.names.push_back(built.names[nearestSlot]);
    }
    if (modesOf(resized.slots) <= maximumModes)
        built = std::move(resized);
}

std::size_t modesOf(std::span<const SynthesiserSlot> slots) {
    std::size_t modes = 0;
    for (const auto& slot : slots)
        modes += slot.object->modeCount();
    return modes;
}

} // namespace idiophone
