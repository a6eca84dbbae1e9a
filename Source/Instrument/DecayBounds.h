// How slowly anything of an instrument can die away, from a few figures of its objects. Asking it
// looks at no mode.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/KeyTuning.h"
#include "Object/DampingLaw.h"
#include "Synth/SynthesisSettings.h"

#include <array>
#include <limits>

namespace idiophone {

/// Bounds of one or more modes: none of them dies away more slowly than a mode of these figures,
/// under any settings. The default bounds no mode.
struct ModeBound {
    double eigenvalue = std::numeric_limits<double>::infinity(); ///< minimum of λ/size²
    double scale = 1;                                            ///< minimum of ModeDamping::scale
    double extraPerSecond = 0; ///< minimum of ModeDamping::extraPerSecond/size
    /// Maximum of Y/ρ [m²/s²] of the objects' own materials: another material makes λ/size² of
    /// these modes lower in inverse proportion.
    double specificStiffness = 0;
    DampingLaw law; ///< minimum of each figure of the objects' own materials

    bool operator==(const ModeBound&) const = default;
};

/// Figures of all modes of all slots, as their objects were analysed. It holds doubles only, so
/// that they can cross threads one by one.
struct DecayBounds {
    /// Modes of which each may be the slowest under some settings. Where there are more than fit,
    /// one bound stands for several that are close to each other.
    std::array<ModeBound, 16> slowest;
    /// Minimum of λ of a slot that keeps its pitch, over λ/size², at the thickness that was
    /// analysed and at any thickness of the parameter; infinite where no slot has a pitch.
    double keptShare = std::numeric_limits<double>::infinity();
    double keptShareAtAnyThickness = std::numeric_limits<double>::infinity();
    double slotsWithoutPitch = 0;
    double mostBending = 0;    ///< maximum of the share of λ on which the thickness acts: 0 to 1
    double mostScale = 0;      ///< maximum of ModeDamping::scale
    double mostExtraShare = 0; ///< maximum of ModeDamping::extraPerSecond/√λ
    DampingLaw most;           ///< maximum of each figure of the objects' own materials
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
