// Keys that scrape, roll or bow while they are held: where each touches its object, its pressure
// and its speed. Synth/ContactForce and Synth/BowedPoint make the force.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/PressedForce.h"
#include "Instrument/StripGlide.h"
#include "Parameters/ParameterTable.h"
#include "Synth/BowedPoint.h"
#include "Synth/ContactWidth.h"
#include "Synth/Synthesiser.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace idiophone {

/// Returns whether keys strike. Otherwise they press a sustained contact.
bool strikes(const ParameterValues& parameters);
/// Returns whether keys bow or rub.
bool bows(const ParameterValues& parameters);

/// Constructed and destroyed off the audio thread; the rest is for the audio thread and neither
/// allocates, locks nor throws. All changes act at the next `sound`. A key is a note on one of the
/// MIDI channels 0 to 15; controllers and channel pressure act on the keys of their channel only.
class HeldContacts {
public:
    /// Maximum of keys held at a time. A further key releases the oldest.
    static constexpr std::size_t capacity = 16;
    static constexpr std::size_t channels = 16;
    /// Value of the speed and place controllers before they move.
    static constexpr int controllerAtRest = 64;

    /// The seed decides where on the profile each contact begins. `instrument` must outlive the
    /// contacts.
    HeldContacts(const Instrument& instrument,
                 std::shared_ptr<const SurfaceProfile> profile,
                 std::uint64_t seed);

    /// Presses a key with this pressure, 0 to 1, until setPressure() changes it. Does nothing for a
    /// key without an object.
    void press(int channel, int note, double pressure) noexcept;
    /// Fades the force out; the object rings on.
    void release(int channel, int note) noexcept;
    void releaseAll() noexcept;
    /// Ends all contacts at once. The caller fades the output.
    void forgetAll() noexcept;

    /// Sets the pressure, 0 to 1, of one held key or of all held keys of a channel.
    void setPressure(int channel, int note, double pressure) noexcept;
    void setPressure(int channel, double pressure) noexcept;
    struct Controllers {
        int speed = controllerAtRest, place = controllerAtRest; ///< 0 to 127
    };
    Controllers& controllers(int channel) noexcept {
        return channelControllers[static_cast<std::size_t>(channel)];
    }
    /// Returns the place on a strip, 0 to 1, to which the place controller moves `along`. At rest
    /// the controller moves nothing; at 0 and 127 it reaches the ends.
    static double placeMoved(int controller, double along) noexcept;
    void takeControllersOf(const HeldContacts& other) noexcept {
        channelControllers = other.channelControllers;
    }
    /// Returns the channel's controllers to rest; held keys press as hard as they were struck.
    void resetControllers(int channel) noexcept;

    /// Applies a cell of every contact's force to the cell that began last, each to its slot's
    /// output. Uses the settings and the slots' frequency ratios of that cell. While the parameters
    /// ask for strikes, every contact counts as released.
    void sound(const ParameterValues& parameters,
               const SynthesisSettings& settings,
               Synthesiser& synthesiser,
               std::span<const CellOutput> cellsOfSlots) noexcept;

    bool silent() const noexcept; ///< no contact, not even a fading one
    void reset() noexcept;        ///< restores the constructed state

private:
    enum class Tool { other, bow, rub };
    struct Contact {
        PressedForce force;
        int channel = 0;
        int note = 0;
        std::uint64_t pressCount = 0;
        double strikePressure = 0; ///< from the note's velocity
        double pressure = 0;
        StripGlide place;
        Tool tool = Tool::other;
        BowedPoint bow;
        PointModes modes; ///< at the bow
        ContactWidth width;
    };

    Contact& begin(int channel, int note) noexcept;
    static Tool toolOf(const ParameterValues& parameters) noexcept;
    void changeTool(Tool tool) noexcept;

    void chooseKind(Contact& contact,
                    const ParameterValues& parameters,
                    SynthesisSettings settings,
                    const Synthesiser& synthesiser) const noexcept;
    void soundOne(Contact& contact,
                  const ParameterValues& parameters,
                  Synthesiser& synthesiser,
                  const CellOutput& cell) noexcept;
    bool bow(Contact& contact,
             const ForcePlace& at,
             const ContactMotion& motion,
             double rough,
             Synthesiser& synthesiser,
             std::span<float, cellSamples> newtons) const noexcept;
    void move(Contact& contact, const Key& key, const ParameterValues& parameters) noexcept;

    Contact* find(int channel, int note) noexcept; ///< the held key, or nullptr
    Contact& freeContact() noexcept;
    void giveWay() noexcept;

    const Instrument& instrument;
    double rateHz;
    std::vector<Contact>
        contacts; ///< twice the capacity: the second half serves while others fade out
    std::uint64_t pressCount = 0;
    std::array<Controllers, channels> channelControllers{};
};

} // namespace idiophone
