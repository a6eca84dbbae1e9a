#include "Instrument/HeldContacts.h"

#include "Instrument/MalletStrike.h"
#include "Instrument/RollCoupling.h"
#include "Instrument/SettingsOfParameters.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace idiophone {
namespace {

using enum ParameterId;
using Vector = std::array<float, 3>;

/// Into the surface, and along the path by the friction.
Vector pushDirection(const StripPlace& place, double friction) {
    const auto along = static_cast<float>(friction);
    Vector push;
    for (std::size_t axis = 0; axis < 3; ++axis)
        push[axis] = along * place.direction[axis] - place.point.normal[axis];
    const float norm = std::hypot(push[0], push[1], push[2]);
    for (float& component : push)
        component /= norm;
    return push;
}

} // namespace

bool strikes(const ParameterValues& parameters) {
    const auto choice = static_cast<int>(parameters[contact]);
    return choice != scrapeContact && choice != rollContact;
}

HeldContacts::HeldContacts(const Instrument& played,
                           std::span<const LowestModes> lowestModesOfSlots,
                           std::shared_ptr<const SurfaceProfile> profile,
                           std::uint64_t seed)
    : instrument(played), lowestModes(lowestModesOfSlots), rateHz(profile->sampleRateHz()),
      // One cell less than fits: the release may have to wait that long for its grid point.
      fadeCells(std::max(1, static_cast<int>(releaseSeconds * rateHz / cellSamples) - 1)) {
    contacts.reserve(capacity);
    for (std::uint64_t i = 0; i < capacity; ++i)
        contacts.push_back({.force = ContactForce(profile, seed * capacity + i), .place = {}});
}

void HeldContacts::press(int note, double pressure) noexcept {
    if (instrument.key(note).slot < 0)
        return;
    auto chosen = std::ranges::find(contacts, note, &Contact::note);
    if (chosen == contacts.end()) {
        const auto isOlder = [](const Contact& a, const Contact& b) {
            return std::tuple(a.note >= 0, a.pressCount) < std::tuple(b.note >= 0, b.pressCount);
        };
        chosen = std::ranges::min_element(contacts, isOlder);
        if (chosen->note >= 0)
            chosen->force.reset();
        chosen->note = note;
        chosen->begins = true;
    }
    chosen->pressCount = ++pressCount;
    chosen->pressure = pressure;
    chosen->fadeCellsLeft = -1;
}

void HeldContacts::release(int note) noexcept {
    for (auto& contact : contacts)
        if (contact.note == note && contact.isHeld())
            contact.fadeCellsLeft = fadeCells;
}

void HeldContacts::releaseAll() noexcept {
    for (auto& contact : contacts)
        if (contact.isHeld())
            contact.fadeCellsLeft = fadeCells;
}

void HeldContacts::stop() noexcept {
    for (auto& contact : contacts) {
        contact.note = -1;
        contact.force.reset();
    }
}

void HeldContacts::setPressure(int note, double pressure) noexcept {
    for (auto& contact : contacts)
        if (contact.note == note && contact.isHeld())
            contact.pressure = pressure;
}

void HeldContacts::setPressure(double pressure) noexcept {
    for (auto& contact : contacts)
        if (contact.isHeld())
            contact.pressure = pressure;
}

void HeldContacts::resetControllers() noexcept {
    speedController = controllerAtRest;
    placeController = controllerAtRest;
}

void HeldContacts::sound(const ParameterValues& parameters,
                         const SynthesisSettings& settings,
                         Synthesiser& synthesiser,
                         const CellOutput& cell) noexcept {
    if (strikes(parameters))
        releaseAll();
    for (auto& contact : contacts)
        if (contact.note >= 0) {
            chooseKind(contact, parameters, settings);
            soundOne(contact, parameters, synthesiser, cell);
        }
}

/// While a contact fades out it stays of its kind, whatever is chosen by then.
void HeldContacts::chooseKind(Contact& contact,
                              const ParameterValues& parameters,
                              const SynthesisSettings& settings) const noexcept {
    if (strikes(parameters))
        return;
    const bool rolls = static_cast<int>(parameters[ParameterId::contact]) == rollContact;
    const double coupling = rolls ? parameters[rollCoupling] / 100 : 0;
    if (coupling > 0) {
        const auto slot = static_cast<std::size_t>(instrument.key(contact.note).slot);
        const auto modes = coupledModes(lowestModes[slot], ownMaterial(contact), settings);
        contact.force.setCoupledModes(modes.span());
    }
    contact.force.setSettings(
        {.kind = rolls ? ContactKind::roll : ContactKind::scrape, .rollModalCoupling = coupling});
}

const Material& HeldContacts::ownMaterial(const Contact& contact) const noexcept {
    const auto slot = static_cast<std::size_t>(instrument.key(contact.note).slot);
    return instrument.slots()[slot].object->material;
}

void HeldContacts::soundOne(Contact& contact,
                            const ParameterValues& parameters,
                            Synthesiser& synthesiser,
                            const CellOutput& cell) noexcept {
    const auto& key = instrument.key(contact.note);
    const auto slot = static_cast<std::size_t>(key.slot);
    const auto* chosen = chosenLibraryMaterial(parameters);
    const double friction = (chosen != nullptr ? *chosen : ownMaterial(contact)).friction;
    const StripPlace start = contact.place;
    const double startGain = contact.gain;
    move(contact, key, parameters);
    // What touches a scaled object is scaled with it, as mallets are: an area, s² of the force. The
    // signal is the normal part of the force.
    contact.gain = parameters[roughness] * key.malletScale * key.malletScale *
                   std::sqrt(1 + friction * friction);

    alignas(64) std::array<float, cellSamples> newtons;
    const bool presses = contact.force.render(
        {.speedMetresPerSecond = parameters[contactSpeed] * speedController / 127.0,
         .normalForceNewtons = parameters[contactForce] * pressing(contact)},
        newtons);
    if (presses) {
        const auto& from = contact.begins ? contact.place : start;
        const auto fromGain = static_cast<float>(contact.begins ? contact.gain : startGain);
        const auto gainStep = (static_cast<float>(contact.gain) - fromGain) / cellSamples;
        for (std::size_t i = 0; i < newtons.size(); ++i)
            newtons[i] *= fromGain + static_cast<float>(i + 1) * gainStep;
        synthesiser.applyForce(slot,
                               {.start = from.point,
                                .end = contact.place.point,
                                .startDirection = pushDirection(from, friction),
                                .endDirection = pushDirection(contact.place, friction),
                                .newtons = newtons},
                               cell);
    }
    contact.begins = false;
    if (contact.fadeCellsLeft == 0)
        contact.note = -1;
}

/// The normal force at the end of this cell, as a part of full pressure. What is heard follows its
/// root, which falls linearly after a release.
double HeldContacts::pressing(Contact& contact) const noexcept {
    if (contact.fadeCellsLeft < 0)
        return contact.pressure;
    const double left = static_cast<double>(--contact.fadeCellsLeft) / fadeCells;
    return contact.pressure * left * left;
}

void HeldContacts::move(Contact& contact,
                        const Key& key,
                        const ParameterValues& parameters) const noexcept {
    const auto own = aimedPlace(key.along, parameters);
    const double turn = placeController - controllerAtRest;
    const double target =
        own.along + (turn < 0 ? turn / controllerAtRest * own.along
                              : turn / (127 - controllerAtRest) * (1 - own.along));
    const auto& strip = instrument.strip(key);
    const double cellSeconds = cellSamples / rateHz;
    const double ratio =
        instrument.slots()[static_cast<std::size_t>(key.slot)].sizeRatio * parameters[size];
    const double furthest =
        fastestGlideMetresPerSecond * cellSeconds / (strip.lengthMetres * ratio);
    // 98 % of the way in the glide time.
    const double approach = (target - contact.along) * -std::expm1(-4 * cellSeconds / glideSeconds);
    contact.along =
        contact.begins ? target : contact.along + std::clamp(approach, -furthest, furthest);
    contact.place = strip.between(contact.along, own.across);
}

bool HeldContacts::silent() const noexcept {
    return std::ranges::none_of(contacts, [](const Contact& contact) { return contact.note >= 0; });
}

void HeldContacts::reset() noexcept {
    stop();
    for (auto& contact : contacts)
        contact.pressCount = 0;
    pressCount = 0;
    resetControllers();
}

} // namespace idiophone
