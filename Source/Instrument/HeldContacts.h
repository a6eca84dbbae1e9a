// Keys that scrape or roll for as long as they are held: where each one touches its object, how
// hard it presses and how fast it moves. What the contact sounds like is Synth/ContactForce's.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/LowestModes.h"
#include "Parameters/ParameterTable.h"
#include "Synth/ContactForce.h"
#include "Synth/Synthesiser.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace idiophone {

/// Whether keys strike, rather than press a contact.
bool strikes(const ParameterValues& parameters);

/// Constructed and destroyed off the audio thread; the rest is for the audio thread and neither
/// allocates, locks nor throws. Everything acts at the next `sound`.
class HeldContacts {
public:
    /// Contacts at a time; beyond, the oldest gives way.
    static constexpr std::size_t capacity = 16;
    /// From a release to silence of the force, however far the next grid point is.
    static constexpr double releaseSeconds = 0.01;
    /// A contact follows CC74 in about this time, but no faster than this speed.
    static constexpr double glideSeconds = 0.02;
    static constexpr double fastestGlideMetresPerSecond = 5;

    /// The seed says where on the profile each contact begins. `instrument` and the lowest modes of
    /// each of its slots outlive the contacts.
    HeldContacts(const Instrument& instrument,
                 std::span<const LowestModes> lowestModes,
                 std::shared_ptr<const SurfaceProfile> profile,
                 std::uint64_t seed);

    /// A key goes down; until other pressure comes, 0 to 1, it presses like this. A key without an
    /// object does nothing.
    void press(int note, double pressure) noexcept;
    /// The force fades out, and the object rings on.
    void release(int note) noexcept;
    void releaseAll() noexcept;
    /// All forces end at once.
    void stop() noexcept;

    /// 0 to 1; of one held key, or of all.
    void setPressure(int note, double pressure) noexcept;
    void setPressure(double pressure) noexcept;
    void setSpeedController(int value) noexcept { speedController = value; } ///< 0 to 127
    void setPlaceController(int value) noexcept { placeController = value; } ///< 0 to 127
    void resetControllers() noexcept;

    /// Applies a cell of every contact's force to the cell begun last, under the settings of that
    /// cell. While the parameters ask for strikes, every contact counts as released.
    void sound(const ParameterValues& parameters,
               const SynthesisSettings& settings,
               Synthesiser& synthesiser,
               const CellOutput& cell) noexcept;

    bool silent() const noexcept; ///< no contact, not even one that fades out
    void reset() noexcept;        ///< as constructed

private:
    struct Contact {
        bool isHeld() const { return note >= 0 && fadeCellsLeft < 0; }

        ContactForce force;
        int note = -1; ///< −1: no contact
        std::uint64_t pressCount = 0;
        double pressure = 0;
        int fadeCellsLeft = -1; ///< −1: not released
        bool begins = false;    ///< nothing of it has sounded yet
        double along = 0;       ///< on the key's strip
        StripPlace place;
        double gain = 0;
    };

    static constexpr int controllerAtRest = 64;

    void chooseKind(Contact& contact,
                    const ParameterValues& parameters,
                    const SynthesisSettings& settings) const noexcept;
    void soundOne(Contact& contact,
                  const ParameterValues& parameters,
                  Synthesiser& synthesiser,
                  const CellOutput& cell) noexcept;
    void move(Contact& contact, const Key& key, const ParameterValues& parameters) const noexcept;
    double pressing(Contact& contact) const noexcept;

    const Material& ownMaterial(const Contact& contact) const noexcept;

    const Instrument& instrument;
    std::span<const LowestModes> lowestModes;
    double rateHz;
    int fadeCells;
    std::vector<Contact> contacts;
    std::uint64_t pressCount = 0;
    int speedController = controllerAtRest;
    int placeController = controllerAtRest;
};

} // namespace idiophone
