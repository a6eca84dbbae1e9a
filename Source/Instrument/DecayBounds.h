// Bounds how slowly any mode of an instrument can decay, from a few figures of its objects. Queries
// do not visit the modes.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/KeyTuning.h"
#include "Object/DampingLaw.h"
#include "Synth/SynthesisSettings.h"

#include <array>
#include <limits>

namespace idiophone {

/// Bounds one or more modes: under any settings, none of them decays more slowly than a mode with
/// these figures. The default bounds no mode.
struct ModeBound {
    double eigenvalue = std::numeric_limits<double>::infinity(); ///< minimum of λ/size²
    double scale = 1;                                            ///< minimum of ModeDamping::scale
    double extraPerSecond = 0; ///< minimum of ModeDamping::extraPerSecond/size
    /// Maximum of Y/ρ [m²/s²] of the objects' own materials. A live material scales λ/size² of
    /// these modes by its own Y/ρ divided by this value.
    double specificStiffness = 0;
    DampingLaw law; ///< minimum of each figure of the objects' own materials

    bool operator==(const ModeBound&) const = default;
};

/// Bounds of all modes of all slots, as their objects were analysed. All fields are doubles, so
/// that they can cross threads one by one.
struct DecayBounds {
    /// Modes that may each be the slowest under some settings. If there are more than fit, one
    /// bound stands for several similar ones.
    std::array<ModeBound, 16> slowest;
    /// For slots that keep their pitch: minimum of λ over λ/size², at the analysed thickness and at
    /// any thickness of the parameter. Infinite if no slot has a pitch.
    double keptShare = std::numeric_limits<double>::infinity();
    double keptShareAtAnyThickness = std::numeric_limits<double>::infinity();
    double slotsWithoutPitch = 0;
    double maximumBending = 0;    ///< maximum of the share of λ that the thickness changes: 0 to 1
    double maximumScale = 0;      ///< maximum of ModeDamping::scale
    double maximumExtraShare = 0; ///< maximum of ModeDamping::extraPerSecond/√λ
    DampingLaw most;              ///< maximum of each figure of the objects' own materials
};

enum class RingingKeys { own, all };

/// Returns the bounds of all slots. RingingKeys::own leaves out keys that play a neighbour's object
/// (see Key::isOwn), which may be so large that they ring for minutes. Without slots the decay is
/// infinitely fast. Takes time with the number of modes.
DecayBounds decayBounds(const Instrument& instrument, RingingKeys keys = RingingKeys::all);

/// Returns α > 0 [1/s]: no sounding mode decays more slowly under these settings, if no slot is
/// more than `semitonesBelow` below its key in equal temperament. Any thread; takes constant time.
double slowestDecay(const DecayBounds& bounds,
                    const SynthesisSettings& settings,
                    double semitonesBelow) noexcept;

/// Returns how far the lowest of the keys' objects lies below equal temperament, in semitones ≥ 0.
/// Any thread.
double semitonesBelowEqual(const Instrument& instrument, const KeyTuning& tuning);

} // namespace idiophone
