// How far wheels bend each note: one wheel for all, or in an MPE zone (MIDI Polyphonic Expression
// 1.0) one for every note beside the zone's own.
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
/// Zones are as the parameter "MPE" has them, none or one of fifteen members above channel 0, or as
/// MIDI has configured them since it moved last (RPN 6 on channel 0 or 15). Notes of a member
/// channel are bent by its wheel while they are held, and keep their bend as they ring on, since
/// the channel may go to another note. On top of it a zone's own wheel bends the zone's notes, and
/// those of the channels outside of zones bend all notes of these channels. Ranges are the
/// parameters' until MIDI gives another one (RPN 0), which holds until the parameter moves.
///
/// A parameter that moves to what MIDI gave changes nothing: it is to move along.
class PitchBend {
public:
    /// What MIDI gave of the parameters `mpe` and `mpe_bend_range`.
    struct Given {
        std::optional<double> mpe, memberRange;
    };

    /// Once before the events of a block.
    void setParameters(const ParameterValues& parameters) noexcept;

    void noteOn(int channel, int note) noexcept;
    void noteOff(int channel, int note) noexcept;
    void releaseNotes() noexcept;                        ///< of all channels
    void wheel(int channel, int low, int high) noexcept; ///< two bytes of 7 bits
    /// Follows RPN 0 and 6, and "reset all controllers".
    void controller(int channel, int number, int value) noexcept;

    /// Since this was asked last.
    Given takeGiven() noexcept { return std::exchange(newlyGiven, {}); }
    /// Zones and ranges are the parameters' again.
    void forgetGiven() noexcept;

    /// By the wheel that bends the note as others; before it was played, and of none (−1), by that
    /// of channel 0.
    double commonSemitones(int note) const noexcept;
    /// On top of it.
    double ownSemitones(int note) const noexcept {
        return noteSemitones[static_cast<std::size_t>(note)];
    }
    /// By how much wheels may lower a note.
    double farthestSemitones() const noexcept {
        return commonRange.semitones() + (zones().any() ? memberRange.semitones() : 0);
    }
    struct Channels {
        int first = 0, last = 0;
    };
    /// Those on which a controller or pressure of that channel acts: its zone, where the channel is
    /// a zone's own, else itself alone.
    Channels reachOf(int channel) const noexcept;

    void takeWheelsOf(const PitchBend& other) noexcept;
    void takeSetupOf(const PitchBend& other) noexcept; ///< zones and ranges
    void reset() noexcept; ///< wheels at rest, no notes; zones and ranges stay

private:
    /// A parameter in semitones that MIDI may replace, by fractions too and beyond its range.
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
        int lowerMembers = 0; ///< channels 1 to this
        int upperMembers = 0; ///< channels 15 − this to 14
        bool any() const noexcept { return lowerMembers > 0 || upperMembers > 0; }
    };

    /// Whose notes have a wheel in common.
    enum Group : std::uint8_t { lowerZone, upperZone, outside, groupCount };

    Zones zones() const noexcept;
    Group groupOf(int channel) const noexcept;
    bool isMember(int channel) const noexcept;
    void configure(int managerChannel, int members) noexcept;
    Range& rangeOf(int channel) noexcept { return isMember(channel) ? memberRange : commonRange; }
    void giveRange(int channel, int semitones, int cents) noexcept;
    void bendHeldNotes() noexcept;
    void forgetParameter(int channel) noexcept;
    void forgetNotes() noexcept;

    bool mpeParameter = false;
    std::optional<Zones> configured; ///< by MIDI, since the parameter moved last
    Given newlyGiven;
    Range commonRange{ParameterId::bendRange}, memberRange{ParameterId::mpeBendRange};
    std::array<double, groupCount> commonBends{};            ///< −1 to 1
    std::array<double, 16> memberBends{};                    ///< −1 to 1
    std::array<double, 128> noteSemitones{};                 ///< by members' wheels
    std::array<Group, 128> noteGroups = allOf<128>(outside); ///< since each was played last
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
