#include "Instrument/HandScrape.h"

#include "Instrument/SettingsOfParameters.h"
#include "Instrument/StrikePointMetres.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {
namespace {

using enum ParameterId;

// The indices of the hand's forces follow those of the keys.
constexpr std::size_t firstForce = 2 * HeldContacts::capacity, contactCount = 2;
static_assert(firstForce + contactCount <= HandScrape::firstFreeForce);

/// Keeps the hand's seed far from those of any key.
constexpr std::uint64_t apartFromKeys = std::uint64_t{1} << 62;

} // namespace

HandScrape::HandScrape(const Instrument& played,
                       std::shared_ptr<const SurfaceProfile> profile,
                       std::uint64_t seed,
                       std::vector<double> slotStrengths)
    : instrument(played), cellSeconds(cellSamples / profile->sampleRateHz()),
      strengths(std::move(slotStrengths)) {
    for (std::size_t k = 0; k < contactCount; ++k)
        contacts.push_back(
            {.force = PressedForce(profile, (seed * contactCount + k) ^ apartFromKeys),
             .path = {},
             .place = {}});
}

SurfacePath::Point HandScrape::metresOf(const SurfaceTouch& touch) const noexcept {
    return strikePointMetres(*instrument.slots()[touch.slot].object, touch.point);
}

void HandScrape::touch(const SurfaceTouch& touch) noexcept {
    if (!(touch.pressure > 0)) {
        lift();
        return;
    }
    if (touches() && contacts[now].slot != touch.slot)
        lift();
    if (!touches()) {
        // A contact that has made no sound yet needs no fade-out.
        if (!contacts[now].force.isActive() || !contacts[now].force.begins())
            now = (now + 1) % contactCount;
        Contact& contact = contacts[now];
        contact.force.begin();
        contact.slot = touch.slot;
        contact.path.begin(touch.point, metresOf(touch));
    }
    contacts[now].pressure = std::min(touch.pressure, 1.0);
    contacts[now].path.extendTo(touch.point, metresOf(touch));
}

void HandScrape::lift() noexcept {
    contacts[now].force.release();
}

void HandScrape::sound(const ParameterValues& parameters,
                       Synthesiser& synthesiser,
                       std::span<const CellOutput> cellsOfSlots) noexcept {
    for (Contact& contact : contacts)
        if (contact.force.isActive())
            soundOne(contact, parameters, synthesiser, cellsOfSlots[contact.slot]);
}

void HandScrape::soundOne(Contact& contact,
                          const ParameterValues& parameters,
                          Synthesiser& synthesiser,
                          const CellOutput& cell) noexcept {
    const auto& slot = instrument.slots()[contact.slot];
    const double friction = contactMaterial(parameters, slot.object->material).friction;
    const double ratio = slot.sizeRatio * parameters[size];
    const double metresPerSecond =
        ratio * contact.path.advance(cellSeconds, fastestMetresPerSecond / ratio);
    const ForcePlace before = contact.place;
    const bool begins = contact.force.begins();
    contact.place = contact.path.place(friction);
    alignas(64) std::array<float, cellSamples> newtons;
    if (contact.force.render({.speedMetresPerSecond = metresPerSecond,
                              .normalForceNewtons = parameters[contactForce] * contact.pressure},
                             strengths[contact.slot] * parameters[roughness] *
                                 forceScale(instrument.mallet(contact.slot)),
                             newtons))
        synthesiser.applyForce(
            contact.slot,
            {.contact = firstForce + static_cast<std::size_t>(&contact - contacts.data()),
             .start = begins ? contact.place : before,
             .end = contact.place,
             .newtons = newtons},
            cell);
}

std::optional<std::size_t> HandScrape::heldSlot() const noexcept {
    return touches() ? std::optional(contacts[now].slot) : std::nullopt;
}

bool HandScrape::silent() const noexcept {
    return std::ranges::none_of(contacts,
                                [](const Contact& contact) { return contact.force.isActive(); });
}

void HandScrape::reset() noexcept {
    for (Contact& contact : contacts)
        contact.force.end();
    now = 0;
}

} // namespace idiophone
