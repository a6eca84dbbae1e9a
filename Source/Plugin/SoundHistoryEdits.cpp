// Turns changes by hand into undo steps; handles variants and auditions.
#include "Plugin/SoundHistory.h"

#include "Instrument/Mutation.h"

#include <algorithm>

namespace idiophone {

void SoundHistory::beginGesture(ParameterId parameter) {
    followHost();
    if (gestures.none() && openEdits == 0)
        closeEdit();
    gestures.set(static_cast<std::size_t>(parameter));
}

void SoundHistory::willChange(ParameterId parameter) {
    if (openEdits == 0 && !gestures.test(static_cast<std::size_t>(parameter)))
        return;
    followHost();
    const auto known =
        std::ranges::any_of(changes, [&](const Change& c) { return c.parameter == parameter; });
    if (!known)
        changes.push_back({.parameter = parameter, .before = parameters[parameter].exactValue()});
}

void SoundHistory::endGesture(ParameterId parameter) {
    followHost();
    gestures.reset(static_cast<std::size_t>(parameter));
    if (gestures.none() && openEdits == 0)
        closeEdit();
}

void SoundHistory::endAllGestures() {
    followHost();
    gestures.reset();
    openEdits = 0;
    closeEdit();
    editName.clear();
}

void SoundHistory::beginEdit(const std::string& name) {
    followHost();
    if (openEdits++ > 0)
        return;
    closeEdit();
    editName = name;
}

void SoundHistory::endEdit() {
    followHost();
    if (openEdits == 0 || --openEdits > 0)
        return;
    closeEdit();
    editName.clear();
}

void SoundHistory::change(const std::vector<Change>& wanted, bool forward) {
    const auto set = [&](const Change& change) {
        parameters[change.parameter].changeByHand(forward ? change.after : change.before);
    };
    if (forward)
        std::ranges::for_each(wanted, set);
    else
        std::for_each(wanted.rbegin(), wanted.rend(), set);
}

bool SoundHistory::playsB() {
    followHost();
    return isB;
}

// Comparing, copying or mutating an auditioned sound keeps it.

void SoundHistory::compare() {
    keepAudition();
    record(playsB() ? "Compare with A" : "Compare with B", [this] {
        const auto now = holder.loadedSound();
        const auto next = other.value_or(now);
        play({.playing = next, .other = now, .playsB = !isB});
    });
}

void SoundHistory::copyToOther() {
    keepAudition();
    record(playsB() ? "Copy B to A" : "Copy A to B", [this] { other = holder.loadedSound(); });
}

void SoundHistory::mutate(double strength, std::uint32_t seed) {
    keepAudition();
    record("Mutate", [&] {
        const auto now = holder.loadedSound();
        holder.changeParameters(
            now, mutated(now.parameters, now.instrument, now.preset, strength, seed));
    });
}

void SoundHistory::audition(const std::function<void()>& load) {
    followHost();
    closeEdit();
    if (!beforeAudition)
        beforeAudition = session();
    load();
}

void SoundHistory::keepAudition() {
    followHost();
    if (const auto before = std::exchange(beforeAudition, std::nullopt)) {
        closeEdit();
        pushLoad(holder.loadedLabel().name, *before);
    }
}

void SoundHistory::endAudition() {
    followHost();
    if (const auto before = std::exchange(beforeAudition, std::nullopt)) {
        changes.clear();
        play(*before);
    }
}

} // namespace idiophone
