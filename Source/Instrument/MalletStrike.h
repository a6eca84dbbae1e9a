// Turns a key's velocity and the mallet's parameters into a strike: its place, impulse and contact
// time.
#pragma once

#include "Instrument/DrivingPoint.h"
#include "Instrument/KeyMallet.h"
#include "Object/Material.h"
#include "Parameters/ParameterTable.h"
#include "Synth/Strike.h"
#include "Synth/Synthesiser.h"

#include <cstdint>

namespace idiophone {

/// A place on a key's strip.
struct StrikePlace {
    double along = 0;  ///< 0 to 1 on the strip
    double across = 0; ///< −1 to 1
};

/// Returns the key's own place, moved by "strike position". Any thread.
StrikePlace aimedPlace(double keyAlong, const ParameterValues& parameters);

/// Returns the place of a strike: the aimed place plus a random offset by "spread". The same
/// `strikeNumber` always has the same offset, so that a render repeats. Any thread.
StrikePlace
strikePlace(double keyAlong, const ParameterValues& parameters, std::uint32_t strikeNumber);

/// Returns (1 − ν²)/E [1/Pa] of the struck surface: the live material if one is chosen, otherwise
/// the object's own. The custom material has the object's Poisson ratio. Any thread.
double surfaceCompliancePerPa(const Material& own, const ParameterValues& parameters);

/// Returns the chosen mallet, as scaled for a key, on a surface of that compliance [1/Pa]; 0 is
/// rigid. The custom mallet's hardness is the modulus of the whole contact on any surface. The
/// parameter "hardness" multiplies the contact's modulus by 1/60 to 60. A mallet
/// that follows the keys by a share q has a contact of pitchRatio^(q (p+1)) times the modulus, so
/// its contact time on a heavy object falls as pitchRatio^q. Any thread.
Striker
striker(const KeyMallet& key, const ParameterValues& parameters, double surfaceCompliance = 0);

/// Returns the strike at a MIDI velocity, 1 to 127, of the chosen mallet into a slot's object,
/// under the parameters' material, size and thickness. The point's rows must be the object's. Any
/// thread.
Strike malletStrike(const StrikePoint& point,
                    int velocity,
                    const KeyMallet& key,
                    const ParameterValues& parameters,
                    const SynthesiserSlot& struck);

} // namespace idiophone
