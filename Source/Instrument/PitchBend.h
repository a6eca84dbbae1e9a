// Computes how far wheels bend each note: one wheel for all notes, or in an MPE zone (MIDI
// Polyphonic Expression 1.0) also one for each note.
#pragma once

#include "Parameters/ParameterTable.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace idiophone {

/// For the audio thread; neither allocates, locks nor throws. Channels are 0 to 15, notes 0 to 127.
///
/// The parameter "MPE" gives no zone, or one of fifteen members above channel 0. MIDI may configure
/// other zones (RPN 6 on channel 0 or 15), which hold until the parameter moves.
///
/// A member channel's wheel bends its notes while they are held. They keep the bend while they ring
/// on, since the channel may go to another note. A zone's own wheel bends all the zone's notes on
/// top of that. The wheels of channels outside zones bend all notes of these channels. Ranges are
/// the parameters' until MIDI gives another (RPN 0), which holds until the parameter moves.
///
/// A parameter that moves to the value that MIDI gave changes nothing, because it follows MIDI.
class PitchBend {
public:
    /// Values that MIDI gave in place of the parameters `mpe` and `mpe_bend_range`.
    struct Given {
        std::optional<double> mpe, memberRange;
    };

    /// Call once before the events of a block.
    void setParameters(const ParameterValues& parameters) noexcept;

    void noteOn(int channel, int note) noexcept;
    void noteOff(int channel, int note) noexcept;
    void releaseNotes() noexcept;                        ///< on all channels
    void wheel(int channel, int low, int high) noexcept; ///< two bytes of 7 bits
    /// Follows RPN 0 and 6, and Reset All Controllers.
    void controller(int channel, int number, int value) noexcept;

    /// Returns the values given since the last call.
    Given takeGiven() noexcept { return std::exchange(newlyGiven, {}); }
    /// Resets zones and ranges to those of the parameters.
    void forgetGiven() noexcept;

    /// Returns the bend by the wheel that the note shares with others. A note that was never
    /// played, or −1 for no note, follows channel 0.
    double commonSemitones(int note) const noexcept;
    /// Returns the bend by the note's own wheel, which adds to `commonSemitones`.
    double ownSemitones(int note) const noexcept {
        return noteSemitones[static_cast<std::size_t>(note)];
    }
    /// Returns how far wheels may lower a note.
    double maximumSemitones() const noexcept {
        return commonRange.semitones() + (zones().any() ? memberRange.semitones() : 0);
    }
    struct Channels {
        int first = 0, last = 0;
    };
    /// Returns the channels on which a controller or pressure of this channel acts: all of its zone
    /// for a zone's own channel, otherwise the channel itself.
    Channels reachOf(int channel) const noexcept;

    void takeWheelsOf(const PitchBend& other) noexcept;
    void takeSetupOf(const PitchBend& other) noexcept; ///< zones and ranges
    void reset() noexcept; ///< wheels at rest, no notes; zones and ranges are kept

private:
    /// A parameter in semitones that MIDI may replace, also with fractions and beyond its range.
    class Range {
    public:
        explicit Range(ParameterId replaced) : id(replaced) {}
        void setParameter(double semitones) noexcept {
            if (semitones != parameter && given && parameterInfo(id).clamped(*given) != semitones)
                given.reset();
            parameter = semitones;
        }
        void give(double semitones) noexcept { given = semitones; }
        void forgetGiven() noexcept { given.reset(); }
        double semitones() const noexcept { return given.value_or(parameter); }

    private:
        ParameterId id;
        double parameter = 0;
        std::optional<double> given;
    };

    struct Zones {
        int lowerMembers = 0; ///< channels 1 to `lowerMembers`
        int upperMembers = 0; ///< channels 15 − `upperMembers` to 14
        bool any() const noexcept { return lowerMembers > 0 || upperMembers > 0; }
    };

    /// Groups of notes that share a wheel.
    enum Group : std::uint8_t { lowerZone, upperZone, outside, groupCount };

    Zones zones() const noexcept;
    Group groupOf(int channel) const noexcept;
    bool isMember(int channel) const noexcept;
    void configure(int managerChannel, int members) noexcept;
    Range& rangeOf(int channel) noexcept { return isMember(channel) ? memberRange : commonRange; }
    void giveRange(int channel, int semitones, int cents) noexcept;
    void bendHeldNotes() noexcept;
    void forgetParameter(int channel) noexcept;

    bool mpeParameter = false;
    std::optional<Zones> configured; ///< by MIDI, since the parameter last moved
    Given newlyGiven;
    Range commonRange{ParameterId::bendRange}, memberRange{ParameterId::mpeBendRange};
    std::array<double, groupCount> commonBends{};            ///< −1 to 1
    std::array<double, 16> memberBends{};                    ///< −1 to 1
    std::array<double, 128> noteSemitones{};                 ///< by member channels' wheels
    std::array<Group, 128> noteGroups = allOf<128>(outside); ///< set when the note was last played
    std::array<std::int8_t, 128> heldBy = allOf<128>(none);  ///< the member channel of each note
    std::array<std::int8_t, 16> parameterMsb = allOf<16>(nullParameter);
    std::array<std::int8_t, 16> parameterLsb = allOf<16>(nullParameter);

    static constexpr std::int8_t none = -1, nullParameter = 127;

    template <std::size_t count, class Value>
    static constexpr std::array<Value, count> allOf(Value value) {
        std::array<Value, count> all{};
        all.fill(value);
        return all;
    }
};

} // namespace idiophone
