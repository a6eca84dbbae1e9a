// How far wheels bend each note: one wheel for all, or in an MPE zone (MIDI Polyphonic Expression
// 1.0) one for every note beside the zone's own.
#pragma once

#include "Parameters/ParameterTable.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace idiophone {

/// For the audio thread; neither allocates, locks nor throws. Channels are 0 to 15, notes 0 to 127.
///
/// Zones are as the parameter "MPE" has them, none or one of fifteen members above channel 0, or as
/// MIDI has configured them since it moved last (RPN 6 on channel 0 or 15). Notes of a member
/// channel are bent by its wheel while they are held, and keep their bend as they ring on, since
/// the channel may go to another note; all other wheels bend all notes. Ranges are the parameters'
/// until MIDI gives another one (RPN 0), which holds until the parameter moves.
class PitchBend {
public:
    /// Once before the events of a block.
    void setParameters(const ParameterValues& parameters) noexcept;

    void noteOn(int channel, int note) noexcept;
    void noteOff(int channel, int note) noexcept;
    void releaseNotes() noexcept;                        ///< of all channels
    void wheel(int channel, int low, int high) noexcept; ///< two bytes of 7 bits
    /// Follows RPN 0 and 6, and "reset all controllers".
    void controller(int channel, int number, int value) noexcept;

    double commonSemitones() const noexcept; ///< of all notes
    /// On top of it.
    double ownSemitones(int note) const noexcept {
        return noteSemitones[static_cast<std::size_t>(note)];
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
    /// A parameter in semitones that MIDI may replace.
    class Range {
    public:
        void setParameter(double semitones) noexcept {
            if (semitones != parameter)
                given.reset();
            parameter = semitones;
        }
        void give(std::optional<double> semitones) noexcept { given = semitones; }
        double semitones() const noexcept { return given.value_or(parameter); }

    private:
        double parameter = 0;
        std::optional<double> given;
    };

    struct Zones {
        int lowerMembers = 0; ///< channels 1 to this
        int upperMembers = 0; ///< channels 15 − this to 14
    };

    Zones zones() const noexcept;
    bool isMember(int channel) const noexcept;
    void configure(int managerChannel, int members) noexcept;
    Range& rangeOf(int channel) noexcept { return isMember(channel) ? memberRange : commonRange; }
    void giveRange(int channel, int semitones, int cents) noexcept;
    void bendHeldNotes() noexcept;
    void forgetParameter(int channel) noexcept;
    void forgetNotes() noexcept;

    bool mpeParameter = false;
    std::optional<Zones> configured; ///< by MIDI, since the parameter moved last
    Range commonRange, memberRange;
    double commonBend = 0;                                  ///< −1 to 1
    std::array<double, 16> memberBends{};                   ///< −1 to 1
    std::array<double, 128> noteSemitones{};                ///< by members' wheels
    std::array<std::int8_t, 128> heldBy = allOf<128>(none); ///< the member channel of each note
    std::array<std::int8_t, 16> parameterMsb = allOf<16>(127), parameterLsb = allOf<16>(127);

    static constexpr std::int8_t none = -1;

    template <std::size_t count>
    static constexpr std::array<std::int8_t, count> allOf(std::int8_t value) {
        std::array<std::int8_t, count> all{};
        all.fill(value);
        return all;
    }
};

} // namespace idiophone
