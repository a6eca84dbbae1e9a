// SPDX-License-Identifier: Apache-2.0
#include "Synth/Synthesiser.h"

#include "Synth/AwakeSlots.h"
#include "Synth/PrefetchObject.h"
#include "Synth/RegroupTurns.h"

#include <algorithm>
#include <deque>
#include <map>
#include <utility>

namespace idiophone {

struct Synthesiser::Implementation {
    double sampleRate;
    std::unique_ptr<SynthesisScratch> scratch;
    std::vector<AmplitudeEnvelope> envelopes; ///< of the objects
    std::deque<ModalResonator> objects;       ///< do not move
    std::optional<AwakeSlots> slots;          ///< made after the objects
    SynthesisSettings settings;
    bool settingsChanged = false;
    std::vector<char> wasTouched; ///< of every slot, since its last reset
    std::optional<RegroupTurns> turns;
    bool isNew = true; ///< nothing has sounded since the construction or reset

    void settle();
    void settleIfNew() {
        if (std::exchange(isNew, false))
            settle();
    }
    template <class Value>
    void set(std::size_t slot, void (ModalResonator::*setter)(Value) noexcept, Value value);
    template <class Action>
    bool act(std::size_t slot, Action action);
    template <class Apply>
    bool press(std::size_t slot, Apply apply);
};

Synthesiser::Synthesiser(std::vector<SynthesiserSlot> slots,
                         double sampleRateHz,
                         std::size_t channels)
    : implementation(std::make_unique<Implementation>()) {
    auto& all = *implementation;
    all.sampleRate = sampleRateHz;
    std::size_t maximumModes = 0;
    for (SynthesiserSlot& slot : slots) {
        if (!slot.object)
            slot.object = std::make_shared<const ModalObject>();
        maximumModes = std::max(maximumModes, slot.object->modeCount());
    }
    all.scratch = std::make_unique<SynthesisScratch>(maximumModes, channels);
    all.envelopes.resize(slots.size());
    std::map<const ModalObject*, ModeGroups::ModeWeights> known; // one for all slots of an object
    for (SynthesiserSlot& slot : slots) {
        auto& modeWeights = known[slot.object.get()];
        if (!modeWeights)
            modeWeights =
                std::make_shared<const std::vector<double>>(summedSquareShapes(*slot.object));
        const std::size_t number = all.objects.size();
        all.objects.emplace_back(std::move(slot), modeWeights, static_cast<std::uint32_t>(number),
                                 channels, sampleRateHz, *all.scratch, all.envelopes[number]);
    }
    all.slots.emplace(all.objects, all.envelopes);
    all.wasTouched.resize(slots.size());
    all.turns.emplace(slots.size());
}

Synthesiser::~Synthesiser() = default;

void Synthesiser::setSettings(const SynthesisSettings& settings) noexcept {
    auto& all = *implementation;
    const SynthesisSettings wanted = corrected(settings, all.settings);
    all.settingsChanged = all.settingsChanged || wanted != all.settings;
    all.settings = wanted;
}

void Synthesiser::settle() noexcept {
    implementation->isNew = false;
    implementation->settle();
}

void Synthesiser::Implementation::settle() {
    settingsChanged = false;
    for (ModalResonator& object : objects)
        object.settle(settings, slots->cell());
    slots->letAllSleep();
}

template <class Value>
void Synthesiser::Implementation::set(std::size_t slot,
                                      void (ModalResonator::*setter)(Value) noexcept,
                                      Value value) {
    if (slot >= objects.size())
        return;
    (objects[slot].*setter)(value);
    if (!objects[slot].hasNewControls())
        return;
    slots->wake(slot);
    turns->restart();
}

void Synthesiser::setDamping(std::size_t slot, double dampingPerSecond) noexcept {
    implementation->set(slot, &ModalResonator::setDamping, dampingPerSecond);
}

void Synthesiser::setFrequencyRatio(std::size_t slot, double ratio) noexcept {
    auto& all = *implementation;
    if (slot >= slotCount())
        return;
    ModalResonator& object = all.objects[slot];
    object.setFrequencyRatio(ratio);
    if (!object.hasNewControls())
        return;
    all.turns->restart();
    if (!object.silent()) // a silent object follows in its turn, or when it is struck
        all.slots->wake(slot);
}

double Synthesiser::frequencyRatio(std::size_t slot) const noexcept {
    return slot < slotCount() ? implementation->objects[slot].frequencyRatio() : 1;
}

void Synthesiser::setMaterial(std::size_t slot,
                              const std::optional<LiveMaterial>& material) noexcept {
    if (!material || valid(*material))
        implementation->set<const std::optional<LiveMaterial>&>(slot, &ModalResonator::setMaterial,
                                                                material);
}

void Synthesiser::setSilencedModes(std::size_t slot,
                                   std::span<const std::uint8_t> silenced) noexcept {
    implementation->set(slot, &ModalResonator::setSilencedModes, silenced);
}

void Synthesiser::setTubeOpening(const TubeOpening& opening) noexcept {
    implementation->scratch->tubes = opening;
}

void Synthesiser::beginCell(const CellOutput& cell) noexcept {
    cell.clear();
    mixInto([&cell](std::size_t) -> const CellOutput& { return cell; });
}

void Synthesiser::beginCell(std::span<const CellOutput> cellsOfSlots) noexcept {
    for (const CellOutput& cell : cellsOfSlots)
        cell.clear();
    mixInto([cellsOfSlots](std::size_t slot) -> const CellOutput& { return cellsOfSlots[slot]; });
}

template <class CellOf>
void Synthesiser::mixInto(CellOf cellOf) noexcept {
    auto& all = *implementation;
    all.settleIfNew();
    if (all.settingsChanged)
        all.turns->restart();
    all.scratch->tubesNow = all.scratch->tubes.start;
    all.slots->beginCell(all.settings, std::exchange(all.settingsChanged, false));
    for (const std::int32_t number : all.slots->list()) {
        const std::size_t slot = index(number);
        all.objects[slot].mix(all.slots->share(slot), cellOf(slot));
    }
    all.scratch->tubesNow = all.scratch->tubes.end;
    all.slots->report();
    const std::size_t given = all.turns->give([&all](std::size_t slot) -> std::size_t {
        ModalResonator& object = all.objects[slot];
        if (!object.wantsToRegroup())
            return 0;
        object.letRegroup();
        all.slots->wake(slot);
        return object.modeCount();
    });
    all.scratch->modesToRegroup =
        std::int64_t{RegroupTurns::modesPerCell} - static_cast<std::int64_t>(given);
}

/// Lets an action on an existing slot take place in the current cell.
template <class Action>
bool Synthesiser::Implementation::act(std::size_t slot, Action action) {
    settleIfNew();
    ModalResonator& object = objects[slot];
    prefetchObject(object);
    wasTouched[slot] = 1;
    object.moveTo(slots->cell());
    const std::int32_t modesBefore = object.modesMixed();
    const bool done = action(object);
    slots->update(slot, modesBefore);
    return done;
}

bool Synthesiser::strike(std::size_t slot,
                         const Strike& strike,
                         double sampleInCell,
                         const CellOutput& cell) noexcept {
    auto& all = *implementation;
    return slot < slotCount() && all.act(slot, [&](ModalResonator& object) {
        const StrikeAllowance allowed = all.slots->strikeAllowance(slot);
        object.catchUp(all.settings);
        return object.strike(strike, sampleInCell, allowed, cell);
    });
}

bool Synthesiser::contactsUsedUp(std::size_t slot) const noexcept {
    return slot < slotCount() && implementation->objects[slot].contactsUsedUp();
}

template <class Apply>
bool Synthesiser::Implementation::press(std::size_t slot, Apply apply) {
    return slot < objects.size() && act(slot, [&](ModalResonator& object) {
               if (object.silent())
                   object.catchUp(settings);
               return apply(object, slots->forceAllowance(slot));
           });
}

bool Synthesiser::applyForce(std::size_t slot,
                             const ForceCell& force,
                             const CellOutput& cell) noexcept {
    return implementation->press(slot, [&](ModalResonator& object, std::int32_t allowance) {
        return object.applyForce(force, allowance, cell);
    });
}

bool Synthesiser::findModes(std::size_t slot, const ForcePlace& place, PointModes& modes) noexcept {
    return implementation->press(
        slot, [&](ModalResonator& object, std::int32_t) { return object.findModes(place, modes); });
}

bool Synthesiser::beginForce(std::size_t slot, const ForceCell& force, HeardForce& heard) noexcept {
    return implementation->press(slot, [&](ModalResonator& object, std::int32_t allowance) {
        return object.beginForce(force, allowance, heard);
    });
}

void Synthesiser::hearForce(std::size_t slot,
                            const HeardForce& heard,
                            const ForceCell& force,
                            std::size_t from,
                            std::size_t count,
                            const CellOutput& cell) const noexcept {
    implementation->objects[slot].hearForce(heard, force, from, count, cell);
}

void Synthesiser::endForce(std::size_t slot, const ForceCell& force) noexcept {
    implementation->act(slot, [&](ModalResonator& object) {
        object.endForce(force);
        return true;
    });
}

void Synthesiser::reset() noexcept {
    auto& all = *implementation;
    // Skip untouched slots: their banks are in the reset state already, and may be large.
    for (std::size_t slot = 0; slot < all.objects.size(); ++slot)
        if (std::exchange(all.wasTouched[slot], 0) != 0)
            all.objects[slot].reset();
    all.slots->reset();
    *all.turns = RegroupTurns(slotCount());
    all.isNew = true;
}

std::span<const SlotStatus> Synthesiser::status() const noexcept {
    return implementation->slots->status();
}

std::int64_t Synthesiser::modesMixed() const noexcept {
    std::int64_t sum = 0;
    for (const SlotStatus& slot : status())
        sum += slot.modesMixed;
    return sum;
}

void Synthesiser::report(std::size_t slot, SoundingGroups& groups) const noexcept {
    if (slot < slotCount())
        implementation->objects[slot].report(groups, implementation->slots->cell());
}

const SynthesisSettings& Synthesiser::settings() const noexcept {
    return implementation->settings;
}

bool Synthesiser::silent() const noexcept {
    return std::ranges::all_of(implementation->objects, &ModalResonator::silent);
}

bool Synthesiser::silent(std::size_t slot) const noexcept {
    return slot >= slotCount() || implementation->objects[slot].silent();
}

double Synthesiser::sampleRateHz() const noexcept {
    return implementation->sampleRate;
}

std::size_t Synthesiser::slotCount() const noexcept {
    return implementation->objects.size();
}

} // namespace idiophone
