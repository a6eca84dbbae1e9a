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

/// How much of the roughness a bow's friction has.
constexpr double bowRoughness = 0.2;

/// A bow's speed over that of a scrape.
constexpr double bowSlowness = 0.2;

} // namespace

bool strikes(const ParameterValues& parameters) {
    const auto choice = static_cast<int>(parameters[contact]);
    return choice < scrapeContact || choice > rubContact;
}

bool bows(const ParameterValues& parameters) {
    const auto choice = static_cast<int>(parameters[contact]);
    return choice == bowContact || choice == rubContact;
}

HeldContacts::Tool HeldContacts::toolOf(const ParameterValues& parameters) noexcept {
    const auto choice = static_cast<int>(parameters[ParameterId::contact]);
    return choice == bowContact ? Tool::bow : choice == rubContact ? Tool::rub : Tool::other;
}

HeldContacts::HeldContacts(const Instrument& played,
                           std::shared_ptr<const SurfaceProfile> profile,
                           std::uint64_t seed)
    : instrument(played), rateHz(profile->sampleRateHz()) {
    static_assert(2 * capacity <= forceCapacity);
    contacts.reserve(2 * capacity);
    for (std::uint64_t i = 0; i < 2 * capacity; ++i) {
        // The second half gets seeds far from those of any other instance.
        const auto apart = i < capacity ? 0 : std::uint64_t{1} << 63;
        contacts.push_back(
            {.force = PressedForce(profile, (seed * capacity + i % capacity) ^ apart),
             .place = {},
             .bow = BowedPoint(rateHz),
             .modes = {},
             .width = {}});
    }
}

HeldContacts::Contact* HeldContacts::find(int channel, int note) noexcept {
    const auto found = std::ranges::find_if(contacts, [=](const Contact& contact) {
        return contact.force.isHeld() && contact.note == note && contact.channel == channel;
    });
    return found == contacts.end() ? nullptr : &*found;
}

/// Returns an inactive contact, from the first half if possible. Otherwise returns the released one
/// that has faded most; one exists, because there are twice as many contacts as keys.
HeldContacts::Contact& HeldContacts::freeContact() noexcept {
    const auto rank = [this](const Contact& contact) {
        const bool takesOver = &contact - contacts.data() >= std::ptrdiff_t{capacity};
        return std::tuple(contact.force.isHeld(), contact.force.fade(), takesOver,
                          contact.pressCount);
    };
    return *std::ranges::min_element(contacts, {}, rank);
}

/// Releases the oldest held key if `capacity` keys are held.
void HeldContacts::giveWay() noexcept {
    Contact* oldest = nullptr;
    std::size_t held = 0;
    for (auto& contact : contacts)
        if (contact.force.isHeld()) {
            ++held;
            if (oldest == nullptr || contact.pressCount < oldest->pressCount)
                oldest = &contact;
        }
    if (held >= capacity)
        oldest->force.release();
}

HeldContacts::Contact& HeldContacts::begin(int channel, int note) noexcept {
    Contact& contact = freeContact();
    contact.force.begin();
    contact.bow.reset();
    contact.width.reset();
    contact.channel = channel;
    contact.note = note;
    return contact;
}

void HeldContacts::press(int channel, int note, double pressure) noexcept {
    if (instrument.key(note).slot < 0)
        return;
    auto* chosen = find(channel, note);
    if (chosen == nullptr) {
        giveWay();
        chosen = &begin(channel, note);
    }
    chosen->pressCount = ++pressCount;
    chosen->strikePressure = chosen->pressure = pressure;
}

void HeldContacts::release(int channel, int note) noexcept {
    if (auto* contact = find(channel, note))
        contact->force.release();
}

void HeldContacts::releaseAll() noexcept {
    for (auto& contact : contacts)
        contact.force.release();
}

void HeldContacts::setPressure(int channel, int note, double pressure) noexcept {
    if (auto* contact = find(channel, note))
        contact->pressure = pressure;
}

void HeldContacts::setPressure(int channel, double pressure) noexcept {
    for (auto& contact : contacts)
        if (contact.channel == channel && contact.force.isHeld())
            contact.pressure = pressure;
}

double HeldContacts::placeMoved(int controller, double along) noexcept {
    const double turn = controller - controllerAtRest;
    return along + (turn < 0 ? turn / controllerAtRest * along
                             : turn / (127 - controllerAtRest) * (1 - along));
}

void HeldContacts::resetControllers(int channel) noexcept {
    controllers(channel) = {};
    for (auto& contact : contacts)
        if (contact.channel == channel && contact.force.isHeld())
            contact.pressure = contact.strikePressure;
}

void HeldContacts::sound(const ParameterValues& parameters,
                         const SynthesisSettings& settings,
                         Synthesiser& synthesiser,
                         std::span<const CellOutput> cellsOfSlots) noexcept {
    if (strikes(parameters))
        releaseAll();
    else
        changeTool(toolOf(parameters));
    for (auto& contact : contacts)
        if (contact.force.isActive()) {
            chooseKind(contact, parameters, settings, synthesiser);
            soundOne(contact, parameters, synthesiser,
                     cellsOfSlots[static_cast<std::size_t>(instrument.key(contact.note).slot)]);
        }
}

/// Contacts that have sounded with another tool fade out, and new ones go on.
void HeldContacts::changeTool(Tool tool) noexcept {
    for (Contact& contact : contacts) {
        if (!contact.force.isHeld() || contact.tool == tool)
            continue;
        Contact* changed = &contact;
        if (!contact.force.begins()) {
            contact.force.release();
            changed = &begin(contact.channel, contact.note);
            changed->pressCount = contact.pressCount;
            changed->strikePressure = contact.strikePressure;
            changed->pressure = contact.pressure;
        }
        changed->tool = tool;
    }
}

/// A contact that fades out keeps its kind, even if the parameters change.
void HeldContacts::chooseKind(Contact& contact,
                              const ParameterValues& parameters,
                              SynthesisSettings settings,
                              const Synthesiser& synthesiser) const noexcept {
    if (strikes(parameters) || contact.tool != toolOf(parameters))
        return;
    const bool rolls = static_cast<int>(parameters[ParameterId::contact]) == rollContact;
    const double coupling = rolls ? parameters[rollCoupling] / 100 : 0;
    if (coupling > 0) {
        const auto slot = static_cast<std::size_t>(instrument.key(contact.note).slot);
        settings.frequencyRatio *= synthesiser.frequencyRatio(slot);
        const auto modes =
            coupledModes(instrument.lowestModes(slot), instrument.slots()[slot], settings);
        contact.force.contact().setCoupledModes(modes.span());
    }
    contact.force.contact().setSettings(
        {.kind = rolls ? ContactKind::roll : ContactKind::scrape, .rollModalCoupling = coupling});
}

void HeldContacts::soundOne(Contact& contact,
                            const ParameterValues& parameters,
                            Synthesiser& synthesiser,
                            const CellOutput& cell) noexcept {
    const auto& key = instrument.key(contact.note);
    const auto slot = static_cast<std::size_t>(key.slot);
    const double friction =
        contactMaterial(parameters, instrument.slots()[slot].object->material).friction;
    const auto forceNow = [&] {
        return contact.tool == Tool::rub
                   ? contact.place.slide()
                   : contact.place.force(contact.tool == Tool::bow ? 0 : friction);
    };
    const ForcePlace before = forceNow();
    const bool begins = contact.force.begins();
    move(contact, key, parameters);
    const ForcePlace end = forceNow();
    const bool isBow = contact.tool != Tool::other;
    // A bow speaks over a large range of forces, which the root spreads over the pressures.
    const ContactMotion motion{
        .speedMetresPerSecond = parameters[contactSpeed] * (isBow ? bowSlowness : 1) *
                                controllers(contact.channel).speed / 127.0,
        .normalForceNewtons =
            parameters[contactForce] * (isBow ? std::sqrt(contact.pressure) : contact.pressure)};
    // The rendered signal is the normal part of the force.
    alignas(64) std::array<float, cellSamples> newtons;
    const bool presses =
        isBow
            ? bow(contact, end, motion, parameters[roughness], synthesiser, newtons)
            : contact.force.render(motion, parameters[roughness] * forceScale(key.mallet), newtons);
    if (presses)
        synthesiser.applyForce(slot,
                               {.contact = static_cast<std::size_t>(&contact - contacts.data()),
                                .start = begins ? end : before,
                                .end = end,
                                .newtons = newtons},
                               cell);
}

/// The voicing changes the loudness of a bow and not its pressure, which decides how it speaks.
bool HeldContacts::bow(Contact& contact,
                       const ForcePlace& at,
                       const ContactMotion& motion,
                       double rough,
                       Synthesiser& synthesiser,
                       std::span<float, cellSamples> newtons) const noexcept {
    const auto& key = instrument.key(contact.note);
    synthesiser.findModes(static_cast<std::size_t>(key.slot), at, contact.modes);
    alignas(64) std::array<float, cellSamples> unevenness;
    contact.force.render({.speedMetresPerSecond = motion.speedMetresPerSecond / bowSlowness,
                          .normalForceNewtons = 1},
                         bowRoughness * rough, unevenness);
    const double pressure =
        contact.force.fade() * key.mallet.scale * key.mallet.scale * motion.normalForceNewtons;
    const bool presses = contact.bow.render(
        contact.modes,
        {.speedMetresPerSecond = motion.speedMetresPerSecond, .normalForceNewtons = pressure},
        unevenness, newtons);
    contact.width.average(contact.modes.softestRadians, newtons);
    for (float& newton : newtons)
        newton *= static_cast<float>(key.mallet.gain);
    return presses;
}

void HeldContacts::move(Contact& contact,
                        const Key& key,
                        const ParameterValues& parameters) noexcept {
    auto goal = aimedPlace(key.along, parameters);
    goal.along = placeMoved(controllers(contact.channel).place, goal.along);
    if (contact.force.begins())
        contact.place.jumpTo(key, goal);
    const auto& slot = instrument.slots()[static_cast<std::size_t>(key.slot)];
    contact.place.moveTo(key, goal, slot.sizeRatio * parameters[size], cellSamples / rateHz);
}

bool HeldContacts::silent() const noexcept {
    return std::ranges::none_of(contacts,
                                [](const Contact& contact) { return contact.force.isActive(); });
}

void HeldContacts::forgetAll() noexcept {
    for (auto& contact : contacts) {
        contact.pressCount = 0;
        contact.force.end();
    }
    pressCount = 0;
}

void HeldContacts::reset() noexcept {
    forgetAll();
    channelControllers = {};
}

} // namespace idiophone
