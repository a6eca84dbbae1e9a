#include "Instrument/Dampers.h"

#include "Instrument/HeldContacts.h"
#include "Instrument/SettingsOfParameters.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {
namespace {

using enum ParameterId;

constexpr double silencingSeconds = 0.02; // T60 of All Sound Off
constexpr int plainVelocity = 64;         // keyboards without a release velocity send 64 or 0

} // namespace

Dampers::Dampers(const Instrument& played, std::size_t slots, bool withMallets)
    : instrument(played), hasMallets(withMallets), damped(slots) {}

void Dampers::liftHands() {
    for (auto& slot : damped)
        slot.isTouched = false;
}

void Dampers::strike(std::size_t slot, const ParameterValues& values) {
    damped[slot].isDead = values[deadStroke] != 0 && strikes(values) && hasMallets;
    damped[slot].isChoked = false;
    damped[slot].quickness = 1;
}

void Dampers::choke(int group) {
    for (std::size_t slot = 0; slot < damped.size(); ++slot)
        if (const auto* part = instrument.part(slot); part != nullptr && part->chokeGroup == group)
            damped[slot].isChoked = true;
}

void Dampers::release(std::size_t slot, int velocity) {
    const double above = std::max(velocity - plainVelocity, 0);
    damped[slot].quickness = std::pow(10, above / (127 - plainVelocity));
}

void Dampers::followKeys(const KeyState& keys, bool pressureDamps) {
    const auto heldKeys = keys.heldKeys();
    for (std::size_t note = 0; note < heldKeys.size(); ++note) {
        if (!heldKeys[note])
            continue;
        for (const Key& key : instrument.keysOf(static_cast<int>(note))) {
            if (key.slot < 0)
                continue;
            auto& slot = damped[static_cast<std::size_t>(key.slot)];
            slot.isHeld = true;
            if (pressureDamps)
                slot.pressure = std::max(slot.pressure, keys.pressure(note));
        }
    }
}

void Dampers::update(const ParameterValues& values,
                     const KeyState& keys,
                     std::optional<std::size_t> heldByHand,
                     std::optional<std::size_t> heldByInput,
                     bool isSilenced,
                     Synthesiser& synthesiser) {
    const bool allRing = values[letRing] != 0 || !hasMallets;
    for (auto& slot : damped) {
        slot.isHeld = allRing || slot.isTouched;
        slot.pressure = 0;
    }
    for (const auto held : {heldByHand, heldByInput})
        if (held)
            damped[*held].isHeld = true;
    followKeys(keys, strikes(values) && hasMallets);
    const double released = decayPerSecond(values[releaseTime]);
    for (std::size_t index = 0; index < damped.size(); ++index) {
        auto& slot = damped[index];
        const double whole = slot.releaseSeconds ? decayPerSecond(*slot.releaseSeconds) : released;
        double perSecond = (slot.isHeld ? slot.pressure * slot.pressure : slot.quickness) * whole;
        if (slot.isDead)
            perSecond = std::max(perSecond, decayPerSecond(deadStrokeSeconds));
        if (slot.isChoked)
            perSecond = std::max(perSecond, decayPerSecond(chokingSeconds));
        if (isSilenced)
            perSecond = decayPerSecond(silencingSeconds);
        if (std::exchange(slot.dampingPerSecond, perSecond) != perSecond)
            synthesiser.setDamping(index, perSecond);
    }
}

void Dampers::reset() {
    for (auto& slot : damped) {
        slot.isDead = slot.isChoked = false;
        slot.quickness = 1;
    }
}

} // namespace idiophone
