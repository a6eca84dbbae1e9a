// What keeps another material or mallet as loud as the preset's own: a gain from predictions of
// loudness. It hears no samples; applying the gain is the business of the player.
#pragma once

#include "Instrument/HeldContacts.h"
#include "Instrument/PhrasePrediction.h"

#include <cstddef>
#include <memory>

namespace idiophone {

/// The gain that makes the material and the mallet of some values as loud as those of the preset as
/// loaded, −40 to 40 dB; all else, such as speed, place and size, is on both sides and stays heard.
/// One gain for all velocities: the mean over PhrasePrediction::velocities, but within 1.5 dB of
/// that of the middle one. It depends on parameters and, for keys that scrape or roll, on the
/// wheel; no key or pressure moves it. 0 where material and mallet are the preset's own, and where
/// nothing sounds with one of the two.
///
/// Constructed and destroyed off the audio thread. The same calls give the same gains.
class LoudnessMatch {
public:
    /// Modes that one `advance` takes in: some 20 µs of work.
    static constexpr std::size_t modesPerCell = 16;

    /// The surface, which is valid, is what keys that scrape or roll sound like. `own` are the
    /// preset's values.
    LoudnessMatch(std::shared_ptr<const Instrument> instrument,
                  const Surface& surface,
                  double sampleRateHz,
                  const ParameterValues& own);

    /// Has the gain of these values at once, however many modes there are: not for the audio
    /// thread. From then on `reset` returns to here.
    void prepare(const ParameterValues& now) noexcept;

    /// Works on the gain of these values and returns how many modes it took in: none while it has
    /// that gain, else at most `modesPerCell`. What moves in the meantime is followed after that.
    /// For every cell, on the audio thread: neither allocates, locks nor throws. Where nothing was
    /// prepared, the first call prepares.
    std::size_t advance(const ParameterValues& now) noexcept;

    /// Where the modulation wheel is, 0 to 127: the speed of scrapes and rolls moves their spectrum
    /// by octaves. At rest until it moves; counts from the next `advance` on.
    void setSpeedController(int value) noexcept { wheel = value; }
    int speedController() const noexcept { return wheel; }

    /// The last gain that was complete.
    double gainDb() const noexcept { return state.gainDb; }

    /// As constructed, or as last prepared; the wheel at rest.
    void reset() noexcept;

    /// Of these values and the wheel, complete; not for the audio thread.
    PhrasePrediction::Loudness predictedLufs(const ParameterValues& values) const noexcept;

private:
    /// What loudness depends on.
    struct Goal {
        ParameterValues values;
        int wheel = 0;

        bool operator==(const Goal&) const = default;
    };
    struct Known {
        bool valid = false;
        Goal goal;
        PhrasePrediction::Loudness lufs{};
    };
    struct State {
        bool prepared = false;
        double gainDb = 0;
        Known reference, played;
        bool working = false;
        bool onReference = false; ///< rather than on what is played
        Goal seen;                ///< what the others are made of
        Goal referenceGoal, playedGoal;
    };

    std::size_t advance(const ParameterValues& now, std::size_t modes) noexcept;
    Goal goalOf(const ParameterValues& values) const noexcept;
    void setGoal(const ParameterValues& now) noexcept;
    void beginNext() noexcept;
    double gainOfKnown() const noexcept;

    Phrase phrase;
    ParameterValues ownValues;
    PhrasePrediction prediction;
    State state, start;
    int wheel = HeldContacts::controllerAtRest;
};

/// The values with all that does not enter a prediction at its default: level, budget and the like,
/// and what the choices of material, mallet and contact leave without effect. Any thread.
ParameterValues valuesThatMatter(const ParameterValues& values) noexcept;

} // namespace idiophone
