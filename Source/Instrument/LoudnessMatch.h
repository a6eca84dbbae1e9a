// How loud an instrument will be, from its modes alone: what keeps another material or mallet as
// loud as the preset's own. It hears no samples; applying the gain is the business of the player.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/LowestModes.h"
#include "Instrument/PhraseMeter.h"
#include "Parameters/ParameterTable.h"
#include "Synth/Surface.h"

#include <array>
#include <cstddef>
#include <memory>

namespace idiophone {

/// Constructed and destroyed off the audio thread. The rest is for the audio thread: it neither
/// allocates, locks nor throws, and depends on nothing but its arguments. It costs one pass over
/// the modes of eight keys' objects, once for an object that all keys share: for when parameters
/// change, not for every cell.
class LoudnessMatch {
public:
    /// The surface, which is valid, is what keys that scrape or roll sound like.
    explicit LoudnessMatch(std::shared_ptr<const Instrument> instrument, Surface surface = {});

    /// The loudness (PhraseMeter.h; the mean of both channels, before `level`) of eight notes from
    /// the lowest key to the highest at velocity 100. Left out: `spread` and what τ and the mode
    /// budget drop. Keys that scrape or roll are predicted up to a constant, rolls as scrapes.
    double predictedLufs(const ParameterValues& parameters, double sampleRateHz) const noexcept;

    /// The gain that makes the material and the mallet of `now` as loud as those of `own`, the
    /// preset's as loaded: −40 to 40 dB. All else, such as speed, place and size, is that of `now`
    /// on both sides and stays heard. 0 where material and mallet are the preset's own, and where
    /// nothing sounds with one of the two.
    double gainDb(const ParameterValues& own,
                  const ParameterValues& now,
                  double sampleRateHz) const noexcept;

private:
    struct PhraseKey {
        Key key;
        LowestModes lowestModes; ///< of its object
        double weightScale = 0;  ///< of its radiation weights (Listening.h)
    };

    void addObject(PhraseMeter& meter,
                   std::size_t firstNote,
                   std::size_t endNote,
                   const ParameterValues& parameters,
                   double sampleRateHz) const noexcept;

    std::shared_ptr<const Instrument> playedInstrument;
    Surface scrapedSurface;
    std::array<PhraseKey, PhraseMeter::notes> keys;
};

} // namespace idiophone
