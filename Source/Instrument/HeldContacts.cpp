#include "Instrument/HeldContacts.h"

#include "Instrument/DraggedForce.h"
#include "Instrument/GainRamp.h"
#include "Instrument/MalletStrike.h"
#include "Instrument/RollCoupling.h"
#include "Instrument/SettingsOfParameters.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace idiophone {
namespace {

using enum ParameterId;

ForcePlace pushed(const StripStep& place, double friction) {
    return {.points = {draggedForce(place.first.point, place.first.direction, friction),
                       draggedForce(place.second.point, place.second.direction, friction)},
            .fraction = static_cast<float>(place.fraction)};
}

} // namespace

bool strikes(const ParameterValues& parameters) {
    const auto choice = static_cast<int>(parameters[contact]);
    return choice != scrapeContact && choice != rollContact;
}

HeldContacts::HeldContacts(const Instrument& played,
                           std::shared_ptr<const SurfaceProfile> profile,
                           std::uint64_t seed)
    : instrument(played), rateHz(profile->sampleRateHz()), releaseFade(rateHz) {
    static_assert(2 * capacity <= forceCapacity);
    contacts.reserve(2 * capacity);
    for (std::uint64_t i = 0; i < 2 * capacity; ++i) {
        // The second half gets seeds far from those of any other instance.
        const auto apart = i < capacity ? 0 : std::uint64_t{1} << 63;
        contacts.push_back(
            {.force = ContactForce(profile, (seed * capacity + i % capacity) ^ apart),
             .place = {}});
    }
}

HeldContacts::Contact* HeldContacts::find(int channel, int note) noexcept {
    const auto found = std::ranges::find_if(contacts, [=](const Contact& contact) {
        return contact.isHeld() && contact.note == note && contact.channel == channel;
    });
    return found == contacts.end() ? nullptr : &*found;
}

/// Returns an inactive contact, from the first half if possible. Otherwise returns the released one
/// that has faded most; one exists, because there are twice as many contacts as keys.
HeldContacts::Contact& HeldContacts::freeContact() noexcept {
    const auto rank = [this](const Contact& contact) {
        const bool takesOver = &contact - contacts.data() >= std::ptrdiff_t{capacity};
        return std::tuple(contact.isHeld(), contact.isActive(),
                          contact.isActive() ? contact.fade : 0, takesOver, contact.pressCount);
    };
    return *std::ranges::min_element(contacts, {}, rank);
}

/// Releases the oldest held key if `capacity` keys are held.
void HeldContacts::giveWay() noexcept {
    Contact* oldest = nullptr;
    std::size_t held = 0;
    for (auto& contact : contacts)
        if (contact.isHeld()) {
            ++held;
            if (oldest == nullptr || contact.pressCount < oldest->pressCount)
                oldest = &contact;
        }
    if (held >= capacity)
        oldest->isReleased = true;
}

void HeldContacts::press(int channel, int note, double pressure) noexcept {
    if (instrument.key(note).slot < 0)
        return;
    auto* chosen = find(channel, note);
    if (chosen == nullptr) {
        giveWay();
        chosen = &freeContact();
        chosen->force.reset();
        chosen->channel = channel;
        chosen->note = note;
        chosen->isReleased = false;
        chosen->fade = 1;
        chosen->begins = true;
    }
    chosen->pressCount = ++pressCount;
    chosen->strikePressure = chosen->pressure = pressure;
}

void HeldContacts::release(int channel, int note) noexcept {
    if (auto* contact = find(channel, note))
        contact->isReleased = true;
}

void HeldContacts::releaseAll() noexcept {
    for (auto& contact : contacts)
        contact.isReleased = true;
}

void HeldContacts::setPressure(int channel, int note, double pressure) noexcept {
    if (auto* contact = find(channel, note))
        contact->pressure = pressure;
}

void HeldContacts::setPressure(int channel, double pressure) noexcept {
    for (auto& contact : contacts)
        if (contact.channel == channel && contact.isHeld())
            contact.pressure = pressure;
}

void HeldContacts::setSpeedController(int channel, int value) noexcept {
    controllers[static_cast<std::size_t>(channel)].speed = value;
}

void HeldContacts::setPlaceController(int channel, int value) noexcept {
    controllers[static_cast<std::size_t>(channel)].place = value;
}

double HeldContacts::placeMoved(int controller, double along) noexcept {
    const double turn = controller - controllerAtRest;
    return along + (turn < 0 ? turn / controllerAtRest * along
                             : turn / (127 - controllerAtRest) * (1 - along));
}

void HeldContacts::resetControllers(int channel) noexcept {
    controllers[static_cast<std::size_t>(channel)] = {};
    for (auto& contact : contacts)
        if (contact.channel == channel && contact.isHeld())
            contact.pressure = contact.strikePressure;
}

void HeldContacts::sound(const ParameterValues& parameters,
                         const SynthesisSettings& settings,
                         Synthesiser& synthesiser,
                         std::span<const CellOutput> cellsOfSlots) noexcept {
    if (strikes(parameters))
        releaseAll();
    for (auto& contact : contacts)
        if (contact.isActive()) {
            chooseKind(contact, parameters, settings, synthesiser);
            soundOne(contact, parameters, synthesiser,
                     cellsOfSlots[static_cast<std::size_t>(instrument.key(contact.note).slot)]);
        }
}

/// A contact that fades out keeps its kind, even if the parameters change.
void HeldContacts::chooseKind(Contact& contact,
                              const ParameterValues& parameters,
                              SynthesisSettings settings,
                              const Synthesiser& synthesiser) const noexcept {
    if (strikes(parameters))
        return;
    const bool rolls = static_cast<int>(parameters[ParameterId::contact]) == rollContact;
    const double coupling = rolls ? parameters[rollCoupling] / 100 : 0;
    if (coupling > 0) {
        const auto slot = static_cast<std::size_t>(instrument.key(contact.note).slot);
        settings.frequencyRatio *= synthesiser.frequencyRatio(slot);
        const auto modes =
            coupledModes(instrument.lowestModes(slot), instrument.slots()[slot], settings);
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
    const StripStep start = contact.place;
    const double startGain = contact.gain;
    move(contact, key, parameters);
    // The rendered signal is the normal part of the force.
    contact.gain = parameters[roughness] * forceScale(key.mallet);

    alignas(64) std::array<float, cellSamples> newtons;
    const bool presses = contact.force.render(
        {.speedMetresPerSecond = parameters[contactSpeed] * controllersOf(contact).speed / 127.0,
         .normalForceNewtons = parameters[contactForce] * contact.pressure},
        newtons);
    if (presses) {
        const auto& from = contact.begins ? contact.place : start;
        applyGainRamp(newtons, contact.begins ? contact.gain : startGain, contact.gain);
        if (contact.isReleased)
            releaseFade.apply(contact.fade, newtons);
        synthesiser.applyForce(slot,
                               {.contact = static_cast<std::size_t>(&contact - contacts.data()),
                                .start = pushed(from, friction),
                                .end = pushed(contact.place, friction),
                                .newtons = newtons},
                               cell);
    }
    contact.begins = false;
    if (contact.isReleased) {
        contact.fade = releaseFade.after(contact.fade);
        if (contact.fade == 0)
            contact.note = -1;
    }
}

void HeldContacts::move(Contact& contact,
                        const Key& key,
                        const ParameterValues& parameters) const noexcept {
    const auto own = aimedPlace(key.along, parameters);
    const double target = placeMoved(controllersOf(contact).place, own.along);
    const auto& strip = instrument.strip(key);
    const double cellSeconds = cellSamples / rateHz;
    const double ratio =
        instrument.slots()[static_cast<std::size_t>(key.slot)].sizeRatio * parameters[size];
    const double furthest =
        fastestGlideMetresPerSecond * cellSeconds / (strip.lengthMetres * ratio);
    if (contact.begins) {
        contact.along = target;
        contact.across = own.across;
    }
    const double share = -std::expm1(-4 * cellSeconds / glideSeconds); // 98 % in the glide time
    contact.along += std::clamp(share * (target - contact.along), -furthest, furthest);
    contact.across += share * (own.across - contact.across);
    contact.place = strip.around(contact.along, contact.across);
}

bool HeldContacts::silent() const noexcept {
    return std::ranges::none_of(contacts, &Contact::isActive);
}

void HeldContacts::forgetAll() noexcept {
    for (auto& contact : contacts) {
        contact.note = -1;
        contact.pressCount = 0;
        contact.force.reset();
    }
    pressCount = 0;
}

void HeldContacts::reset() noexcept {
    forgetAll();
    controllers = {};
}

} // namespace idiophone
