// How slowly anything of an instrument can die away, from a few figures of its objects: no mode is
// looked at when it is asked.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/KeyTuning.h"
#include "Object/DampingLaw.h"
#include "Synth/SynthesisSettings.h"

namespace idiophone {

/// Of all modes of all slots, as their objects were analysed. Numbers and nothing else, so that
/// they can cross threads one by one.
struct DecayBounds {
    double lowestEigenvalue = 0; ///< λ/size²
    /// The same, times the density over Young's modulus of the object's own material.
    double lowestOfUnitMaterial = 0;
    /// λ of the lowest mode where every slot keeps its pitch, at the thickness that was analysed
    /// and at any thickness of the parameter; 0 where slots have no pitch.
    double lowestKept = 0, lowestKeptAtAnyThickness = 0;
    double mostBending = 0;               ///< what the thickness acts on, to λ: 0 to 1
    DampingLaw least, most;               ///< of the objects' own materials
    double leastScale = 1, mostScale = 1; ///< ModalObject::dampingScale
};

enum class RingingKeys { own, all };

/// Returns the bounds of all slots, or of all but those of keys that play a neighbour's object
/// (Key::isOwn): these may be so large that they ring for minutes. Without slots nothing rings: the
/// fastest decay there is. Takes time with the number of modes.
DecayBounds decayBounds(const Instrument& instrument, RingingKeys keys = RingingKeys::all);

/// α > 0 [1/s] of which no mode that sounds is slower under these settings, while no slot is lower
/// than its key in equal temperament by more than so many semitones. Any thread, and at once.
double slowestDecay(const DecayBounds& bounds,
                    const SynthesisSettings& settings,
                    double semitonesBelow) noexcept;

/// By how much the lowest of the keys' objects lies below equal temperament, in semitones ≥ 0. Any
/// thread.
double semitonesBelowEqual(const Instrument& instrument, const KeyTuning& tuning);

} // namespace idiophone
