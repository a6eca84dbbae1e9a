// Models a hand that drags a hard tool over an object, for example over its picture: its place,
// speed and pressure. Synth/ContactForce makes the force.
#pragma once

#include "Instrument/HeldContacts.h"
#include "Instrument/Instrument.h"
#include "Instrument/PressedForce.h"
#include "Instrument/SurfacePath.h"
#include "Parameters/ParameterTable.h"
#include "Synth/Synthesiser.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace idiophone {

/// A move of the hand: to the first place that it touches, or on to another one.
struct SurfaceTouch {
    std::size_t slot = 0; ///< index into the instrument's slots
    StrikePoint point;    ///< on the slot's object
    double pressure = 0;  ///< share of the contact force, 0 to 1; 0 lifts the hand
};

/// Constructed and destroyed off the audio thread; the rest is for the audio thread and neither
/// allocates, locks nor throws. There is one hand; all its moves act at the next `sound`. It
/// scrapes independently of the keys, and is silent while it does not move.
class HandScrape {
public:
    static constexpr double fastestMetresPerSecond = 5;
    /// The first index of a force that neither keys nor the hand use.
    static constexpr std::size_t firstFreeForce = 2 * HeldContacts::capacity + 2;

    /// The seed decides where on the profile the hand begins. Strengths [slots] multiply the
    /// contact force. `instrument` must outlive the hand.
    HandScrape(const Instrument& instrument,
               std::shared_ptr<const SurfaceProfile> profile,
               std::uint64_t seed,
               std::vector<double> strengths);

    /// Moves the hand. If the object changes, the hand lifts and touches the other one. The slot
    /// and the rows must exist.
    void touch(const SurfaceTouch& touch) noexcept;
    /// Fades the force out; the object rings on.
    void lift() noexcept;

    /// Applies a cell of the hand's force to the cell that began last. Each slot's mallet scales
    /// the contact.
    void sound(const ParameterValues& parameters,
               Synthesiser& synthesiser,
               std::span<const CellOutput> cellsOfSlots) noexcept;

    std::optional<std::size_t> heldSlot() const noexcept; ///< slot that the hand touches
    bool silent() const noexcept;                         ///< no contact, not even a fading one
    void reset() noexcept;                                ///< restores the constructed state

private:
    struct Contact {
        PressedForce force;
        std::size_t slot = 0;
        double pressure = 0;
        SurfacePath path;
        ForcePlace place;
    };

    bool touches() const noexcept { return contacts[now].force.isHeld(); }
    SurfacePath::Point metresOf(const SurfaceTouch& touch) const noexcept;
    void soundOne(Contact& contact,
                  const ParameterValues& parameters,
                  Synthesiser& synthesiser,
                  const CellOutput& cell) noexcept;

    const Instrument& instrument;
    double cellSeconds;
    std::vector<double> strengths;
    std::vector<Contact> contacts; ///< two, so that one may fade out while the other plays
    std::size_t now = 0;           ///< index of the newest contact
};

} // namespace idiophone
