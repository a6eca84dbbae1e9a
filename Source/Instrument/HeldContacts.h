// Keys that scrape or roll for as long as they are held: where each one touches its object, how
// hard it presses and how fast it moves. What the contact sounds like is Synth/ContactForce's.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/LowestModes.h"
#include "Instrument/ReleaseFade.h"
#include "Parameters/ParameterTable.h"
#include "Synth/ContactForce.h"
#include "Synth/Synthesiser.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace idiophone {

/// Whether keys strike, rather than press a contact.
bool strikes(const ParameterValues& parameters);

/// Constructed and destroyed off the audio thread; the rest is for the audio thread and neither
/// allocates, locks nor throws. Everything acts at the next `sound`. A key is a note on one of the
/// MIDI channels 0 to 15; controllers and channel pressure act on their channel's keys alone.
class HeldContacts {
public:
    /// Keys held at a time; beyond, the oldest gives way as if it were released.
    static constexpr std::size_t capacity = 16;
    static constexpr std::size_t channels = 16;
    /// A contact follows CC74 and the strike's place in about this time, along the key no faster
    /// than this speed.
    static constexpr double glideSeconds = 0.02;
    static constexpr double fastestGlideMetresPerSecond = 5;

    /// What speed and place controllers are until they are moved.
    static constexpr int controllerAtRest = 64;

    /// The seed says where on the profile each contact begins. `instrument` and the lowest modes of
    /// each of its slots outlive the contacts.
    HeldContacts(const Instrument& instrument,
                 std::span<const LowestModes> lowestModes,
                 std::shared_ptr<const SurfaceProfile> profile,
                 std::uint64_t seed);

    /// A key goes down; until other pressure comes, 0 to 1, it presses like this. A key without an
    /// object does nothing.
    void press(int channel, int note, double pressure) noexcept;
    /// The force fades out, and the object rings on.
    void release(int channel, int note) noexcept;
    void releaseAll() noexcept;
    /// Nothing is in contact, at once. The caller fades the output.
    void forgetAll() noexcept;

    /// 0 to 1; of one held key, or of all of a channel.
    void setPressure(int channel, int note, double pressure) noexcept;
    void setPressure(int channel, double pressure) noexcept;
    void setSpeedController(int channel, int value) noexcept; ///< 0 to 127
    void setPlaceController(int channel, int value) noexcept; ///< 0 to 127
    /// Where the channel's controller moves a place on a strip to, 0 to 1: at rest nowhere, at 0
    /// and 127 to the ends.
    double placeMoved(int channel, double along) const noexcept;
    void takeControllersOf(const HeldContacts& other) noexcept { controllers = other.controllers; }
    /// As before any of the channel moved: held keys press as they were struck.
    void resetControllers(int channel) noexcept;

    /// Applies a cell of every contact's force to the cell begun last, each slot's in its own
    /// output, under the settings and the slots' frequency ratios of that cell. While the
    /// parameters ask for strikes, every contact counts as released.
    void sound(const ParameterValues& parameters,
               const SynthesisSettings& settings,
               Synthesiser& synthesiser,
               std::span<const CellOutput> cellsOfSlots) noexcept;

    bool silent() const noexcept; ///< no contact, not even one that fades out
    void reset() noexcept;        ///< as constructed

private:
    struct Contact {
        bool isActive() const { return note >= 0; }
        bool isHeld() const { return isActive() && !isReleased; }

        ContactForce force;
        int channel = 0;
        int note = -1; ///< −1: no contact
        std::uint64_t pressCount = 0;
        double strikePressure = 0; ///< of its velocity
        double pressure = 0;
        bool isReleased = false;
        double fade = 1;              ///< 0 to 1, falling after the release
        bool begins = false;          ///< nothing of it has sounded yet
        double along = 0, across = 0; ///< on the key's strip
        StripStep place;
        double gain = 0;
    };

    struct Controllers {
        int speed = controllerAtRest;
        int place = controllerAtRest;
    };

    void chooseKind(Contact& contact,
                    const ParameterValues& parameters,
                    SynthesisSettings settings,
                    const Synthesiser& synthesiser) const noexcept;
    void soundOne(Contact& contact,
                  const ParameterValues& parameters,
                  Synthesiser& synthesiser,
                  const CellOutput& cell) noexcept;
    void move(Contact& contact, const Key& key, const ParameterValues& parameters) const noexcept;

    Contact* find(int channel, int note) noexcept; ///< the held key, or nullptr
    Contact& freeContact() noexcept;
    void giveWay() noexcept;
    const Controllers& controllersOf(const Contact& contact) const noexcept {
        return controllers[static_cast<std::size_t>(contact.channel)];
    }
    const Material& ownMaterial(const Contact& contact) const noexcept;

    const Instrument& instrument;
    std::span<const LowestModes> lowestModes;
    double rateHz;
    ReleaseFade releaseFade;
    std::vector<Contact> contacts; ///< the second half takes over from those that fade out
    std::uint64_t pressCount = 0;
    std::array<Controllers, channels> controllers{};
};

} // namespace idiophone
