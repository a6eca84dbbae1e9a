// What keeps another material or mallet as loud as the preset's own: a gain from predictions of
// loudness. It hears no samples; applying the gain is the business of the player.
#pragma once

#include "Instrument/HeldContacts.h"
#include "Instrument/PhrasePrediction.h"

#include <cstddef>
#include <memory>
#include <optional>

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

    /// Has the gain of these values at once, however many modes there are, and knows that of the
    /// wheel at rest and where it is about to be: not for the audio thread.
    void prepare(const ParameterValues& now,
                 int awaitedWheel = HeldContacts::controllerAtRest) noexcept;

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

    /// The wheel at rest. What was predicted for it there stays known: where the values are those
    /// of the last such prediction, the next `advance` has their gain and takes in nothing. Where
    /// nothing was prepared, the first call prepares, as if constructed anew.
    void reset() noexcept;

    /// A song begins: where it does with the values and the wheel that it began with last, the next
    /// `advance` has their gain, and all that is known is as it was then, so that the same values
    /// are followed in the same time again.
    void beginSong() noexcept { songBegins = true; }

    /// Of these values and the wheel, complete; not for the audio thread.
    PhrasePrediction::Loudness predictedLufs(const ParameterValues& values) const noexcept;

private:
    /// What loudness depends on.
    struct Goal {
        ParameterValues values;
        int wheel = 0; ///< at rest for strikes, which it does not move

        bool operator==(const Goal&) const = default;
    };
    struct Known {
        bool valid = false;
        Goal goal;
        PhrasePrediction::Loudness lufs{};
    };
    /// One of the two that are compared. What is known with the wheel at rest has a place of its
    /// own: a reset returns there from wherever the wheel is.
    struct Side {
        Goal goal;
        Known atRest, away;

        Known& known() noexcept;
        bool isKnown() noexcept;
    };
    struct State {
        double gainDb = 0;
        Side reference, played;
        bool working = false;
        bool onReference = false; ///< rather than on what is played
        std::optional<Goal> seen; ///< what the goals are made of
    };

    std::size_t advance(const ParameterValues& now, std::size_t modes) noexcept;
    Goal goalOf(const ParameterValues& values) const noexcept;
    void setGoal(const ParameterValues& now) noexcept;
    void returnToSongStart(const ParameterValues& now) noexcept;
    void beginNext() noexcept;
    double gainOfKnown() noexcept;

    Phrase phrase;
    ParameterValues ownValues;
    PhrasePrediction prediction;
    State state;
    State atSongStart;        ///< complete; of no song where nothing was seen
    bool songBegins = false;  ///< with the next `advance`
    bool isSongStart = false; ///< what is worked on; kept when it is complete
    bool wasPrepared = false; ///< by `prepare`
    bool hasPrepared = false; ///< by it, or by the first `advance`
    int wheel = HeldContacts::controllerAtRest;
};

/// The values with all that does not enter a prediction at its default: level, budget and the like,
/// and what the choices of material, mallet and contact leave without effect. Any thread.
ParameterValues valuesThatMatter(const ParameterValues& values) noexcept;

} // namespace idiophone
