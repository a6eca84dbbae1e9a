// Predicts the gain that keeps another material or mallet as loud as the preset's own.
#pragma once

#include "Instrument/HeldContacts.h"
#include "Instrument/Phrase.h"
#include "Parameters/ParameterTable.h"

#include <optional>
#include <utility>

namespace idiophone {

/// The gain, −40 to 40 dB, that makes the material and mallet of some values as loud as those of
/// the preset as loaded. Speed, place, size and the like are equal on both sides, so their effect
/// stays audible.
/// One gain serves all velocities: the mean over PhrasePrediction::velocities, within 1.5 dB of
/// that of the middle velocity. It depends on parameters and, for keys that scrape or roll, on the
/// wheel; keys and pressure do not change it.
///
/// Immutable: any number of threads may use it at once. Nothing allocates, locks or throws.
class LoudnessMatch {
public:
    /// The inputs of a gain.
    struct Goal {
        ParameterValues values; ///< those that matter: see `valuesThatMatter`
        int wheel = -1;         ///< at rest for strikes, as it does not affect them; −1: no goal

        bool operator==(const Goal&) const = default;
    };

    /// `own` are the preset's values.
    LoudnessMatch(Phrase predicted, const ParameterValues& own)
        : phrase(std::move(predicted)), ownValues(own) {}

    /// Returns what to predict for these values and a modulation wheel at 0 to 127. Returns nothing
    /// if the gain is 0 without a prediction: if "match loudness" is off, or if material and mallet
    /// are the preset's own.
    std::optional<Goal> goalOf(const ParameterValues& now, int wheel) const noexcept;

    /// Predicts the gain; 0 if nothing sounds on one of the two sides. Takes up to a few
    /// milliseconds: not for the audio thread, except offline.
    double gainDb(const Goal& goal) const noexcept;
    /// As above, or 0 without a goal.
    double gainDb(const ParameterValues& now,
                  int wheel = HeldContacts::controllerAtRest) const noexcept {
        const auto goal = goalOf(now, wheel);
        return goal ? gainDb(*goal) : 0;
    }

private:
    Phrase phrase;
    ParameterValues ownValues;
};

/// Returns the values with everything that does not enter a prediction at its default: level,
/// budget and the like, and figures that the choice of material, mallet and contact leaves unused.
/// Any thread.
ParameterValues valuesThatMatter(const ParameterValues& values) noexcept;

} // namespace idiophone
