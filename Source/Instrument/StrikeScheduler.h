// Turns notes and clicks on a surface into impacts at their times.
#pragma once

#include "Instrument/Instrument.h"
#include "Parameters/ParameterTable.h"
#include "Synth/CellStrikes.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace idiophone {

/// A strike at a place of an object without a key, such as a click on its picture.
struct SurfaceStrike {
    std::size_t slot = 0; ///< index into the instrument's slots
    StrikePoint point;    ///< on the slot's object
    int velocity = 0;     ///< 1 to 127; 0 strikes nothing and lifts the hand
};

/// The time of a strike, and the state of cell, parameters and pedal at that time.
struct StrikeMoment {
    BegunCell cell;
    double sample; ///< from the cell's start, at most 64
    const ParameterValues& values;
    double softness = 1; ///< factor of the mallet's speed
};

/// Constructed off the audio thread; the rest is for the audio thread and neither allocates, locks
/// nor throws. The instrument must outlive it. Strikes act in order of time before their samples
/// are played. So their order, and every bit of the output, is the same for all block sizes.
class StrikeScheduler {
public:
    /// The seed decides how strikes spread and chatter.
    StrikeScheduler(const Instrument& instrument, std::uint64_t seed);

    /// Schedules the impacts of a note's strike. `placeController`, 0 to 127, moves the strike
    /// along the key (HeldContacts::placeMoved).
    void strikeKey(const Key& key, int velocity, int placeController, const StrikeMoment& moment);

    /// Keeps a strike until `strikeSurfaces`. Returns false if too many are kept.
    bool keep(const SurfaceStrike& strike);
    bool hasSurfaceStrikes() const { return !surfaceStrikes.empty(); }
    void strikeSurfaces(const StrikeMoment& moment);

    /// Plays, in order of time, the pending impacts before this sample of the cell.
    void strikeBefore(double sampleInCell, const BegunCell& cell) {
        pending.strikeBefore(sampleInCell, cell);
    }

    /// Sets the number of the next strike, from 0 on. It seeds spread and chatter.
    void countFrom(std::uint32_t number) { strikeCount = firstNumber + number; }
    void clear(); ///< drops all strikes
    void reset(); ///< also counts from 0
    bool silent() const { return pending.empty() && surfaceStrikes.empty(); }
    /// Returns the velocity of the last strike, 1 to 127; 0 before the first.
    int velocityStruckLast() const { return struckLast; }

private:
    void strike(std::size_t slot,
                const StrikePoint& point,
                int velocity,
                const KeyMallet& mallet,
                std::uint32_t number,
                const StrikeMoment& moment);

    const Instrument& instrument;
    std::uint32_t firstNumber;
    std::uint32_t strikeCount;
    int struckLast = 0; ///< velocity
    CellStrikes pending;
    std::vector<SurfaceStrike> surfaceStrikes;
};

/// Spreads successive indices to strike numbers that are far apart; 0 stays 0.
constexpr std::uint32_t distantNumber(std::uint64_t index) {
    return static_cast<std::uint32_t>(index * 0x9e3779b97f4a7c15u >> 32);
}

} // namespace idiophone
