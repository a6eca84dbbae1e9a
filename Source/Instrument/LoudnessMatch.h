// Keeps another material or mallet as loud as the preset's own, by a gain from predicted loudness.
// It renders no samples; the player applies the gain.
#pragma once

#include "Instrument/HeldContacts.h"
#include "Instrument/PhrasePrediction.h"

#include <cstddef>
#include <optional>
#include <utility>

namespace idiophone {

/// The gain, −40 to 40 dB, that makes the material and mallet of some values as loud as those of
/// the preset as loaded. Speed, place, size and the like are equal on both sides, so their effect
/// stays audible.
/// One gain serves all velocities: the mean over PhrasePrediction::velocities, within 1.5 dB of
/// that of the middle velocity. It depends on parameters and, for keys that scrape or roll, on the
/// wheel; keys and pressure do not change it. It is 0 if material and mallet are the preset's own,
/// or if nothing sounds with one of the two.
///
/// Constructed and destroyed off the audio thread. The same calls give the same gains.
class LoudnessMatch {
public:
    /// Maximum number of modes that one `advance` processes: about 20 µs of work.
    static constexpr std::size_t modesPerCell = 16;

    /// `own` are the preset's values.
    LoudnessMatch(Phrase predicted, const ParameterValues& own)
        : phrase(std::move(predicted)), ownValues(own) {}

    /// Computes the gain of these values at once, for the present wheel, the wheel at rest and
    /// `awaitedWheel`, where the wheel is about to be. Takes time with the number of modes: not for
    /// the audio thread.
    void prepare(const ParameterValues& now,
                 int awaitedWheel = HeldContacts::controllerAtRest) noexcept;

    /// Works towards the gain of these values. Returns the number of modes processed: 0 once the
    /// gain is complete, otherwise at most `modesPerCell`. Values that change meanwhile have to
    /// wait until then. Call it every cell on the audio thread: it neither allocates, locks nor
    /// throws. Without prepare(), the first call prepares.
    std::size_t advance(const ParameterValues& now) noexcept;

    /// Sets the modulation wheel, 0 to 127; it starts at rest and acts at the next `advance`. The
    /// speed of scrapes and rolls moves their spectrum by octaves.
    void setSpeedController(int value) noexcept { wheel = value; }

    /// Returns the last complete gain.
    double gainDb() const noexcept { return state.gainDb; }

    /// Resets the wheel but keeps the predictions for the wheel at rest. If the values
    /// equal those of the last such prediction, the next `advance` has their gain and processes no
    /// modes. Without prepare(), the next call prepares, as after construction.
    void reset() noexcept;

    /// Marks the start of a song. If values and wheel equal those at the song's last start, the
    /// next `advance` restores the state at that start. So the gain follows the same values in the
    /// same time on every pass.
    void beginSong() noexcept { songBegins = true; }

private:
    /// The values that the loudness depends on.
    struct Goal {
        ParameterValues values;
        int wheel = -1; ///< at rest for strikes, as it does not affect them; −1: no goal yet

        bool operator==(const Goal&) const = default;
    };
    struct Known {
        Goal goal;
        PhrasePrediction::Loudness lufs{};
    };
    /// One of the two compared sides. Predictions with the wheel at rest have their own place,
    /// because a reset needs them at any wheel position.
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
        std::optional<Goal> seen; ///< inputs of the present goals

        /// Returns the side to predict first.
        Side& unknown() noexcept { return reference.isKnown() ? played : reference; }
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
    State atSongStart;        ///< complete; unused while `seen` is empty
    bool songBegins = false;  ///< set until the next `advance`
    bool isSongStart = false; ///< the present work belongs to a song start; stored when complete
    bool wasPrepared = false; ///< by `prepare`
    bool hasPrepared = false; ///< by `prepare` or by the first `advance`
    int wheel = HeldContacts::controllerAtRest;
};

/// Returns the values with everything that does not enter a prediction at its default: level,
/// budget and the like, and figures that the choice of material, mallet and contact leaves unused.
/// Any thread.
ParameterValues valuesThatMatter(const ParameterValues& values) noexcept;

} // namespace idiophone
