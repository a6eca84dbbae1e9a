// A hand that drags something hard over an object beside the keys, such as over its picture: where
// it is, how fast it moves and how hard it presses. What that sounds like is Synth/ContactForce's.
#pragma once

#include "Instrument/HeldContacts.h"
#include "Instrument/Instrument.h"
#include "Instrument/ReleaseFade.h"
#include "Instrument/SurfacePath.h"
#include "Parameters/ParameterTable.h"
#include "Synth/ContactForce.h"
#include "Synth/Synthesiser.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace idiophone {

/// The hand touches a place, or moves on to it.
struct SurfaceTouch {
    std::size_t slot = 0; ///< of the instrument
    StrikePoint point;    ///< on the slot's object
    double pressure = 0;  ///< 0 to 1, of the contact force; 0 lifts the hand
};

/// Constructed and destroyed off the audio thread; the rest is for the audio thread and neither
/// allocates, locks nor throws. There is one hand; everything it does acts at the next `sound`. It
/// scrapes whatever the keys do; standing still it is silent.
class HandScrape {
public:
    static constexpr double fastestMetresPerSecond = 5;

    /// The seed says where on the profile the hand begins. Strengths [slots] multiply the contact
    /// force. `instrument` outlives it.
    HandScrape(const Instrument& instrument,
               std::shared_ptr<const SurfaceProfile> profile,
               std::uint64_t seed,
               std::vector<double> strengths);

    /// From one object to another the hand is lifted and touches again. The slot and the rows
    /// exist.
    void touch(const SurfaceTouch& touch) noexcept;
    /// The force fades out, and the object rings on.
    void lift() noexcept;

    /// Applies a cell of its force to the cell begun last. What touches an object is scaled as
    /// `mallets` says [slots].
    void sound(const ParameterValues& parameters,
               const std::vector<KeyMallet>& mallets,
               Synthesiser& synthesiser,
               std::span<const CellOutput> cellsOfSlots) noexcept;

    std::optional<std::size_t> heldSlot() const noexcept; ///< that it touches
    bool silent() const noexcept; ///< it touches nothing, and nothing of it fades out
    void reset() noexcept;        ///< as constructed

private:
    struct Contact {
        ContactForce force;
        bool isActive = false;
        bool isLifted = false;
        double fade = 1;     ///< 0 to 1, falling after it was lifted
        bool begins = false; ///< nothing of it has sounded yet
        std::size_t slot = 0;
        double pressure = 0;
        SurfacePath path;
        ForcePlace place;
        double gain = 0;
    };

    bool touches() const noexcept { return contacts[now].isActive && !contacts[now].isLifted; }
    SurfacePath::Point metresOf(const SurfaceTouch& touch) const noexcept;
    void soundOne(Contact& contact,
                  const ParameterValues& parameters,
                  double forceRatio,
                  Synthesiser& synthesiser,
                  const CellOutput& cell) noexcept;

    const Instrument& instrument;
    double cellSeconds;
    ReleaseFade releaseFade;
    std::vector<double> strengths;
    std::vector<Contact> contacts; ///< two: one may fade out while the other one is played
    std::size_t now = 0;           ///< the one played last
};

} // namespace idiophone
