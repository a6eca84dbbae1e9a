// From a key's velocity and the mallet's parameters to a contact: where, how hard, how long.
#pragma once

#include "Instrument/DrivingPoint.h"
#include "Instrument/KeyMallet.h"
#include "Instrument/StrikePlace.h"
#include "Object/Material.h"
#include "Parameters/ParameterTable.h"
#include "Synth/Strike.h"
#include "Synth/Synthesiser.h"

#include <cstdint>

namespace idiophone {

/// The key's own place, moved by "strike position". Any thread.
StrikePlace aimedPlace(double keyAlong, const ParameterValues& parameters);

/// The place of a strike: what is aimed at, strayed by "spread". The same `strikeNumber` always
/// strays the same way, so that a render repeats. Any thread.
StrikePlace
strikePlace(double keyAlong, const ParameterValues& parameters, std::uint32_t strikeNumber);

/// (1 − ν²)/E [1/Pa] of what is struck: of the live material where one is chosen, else of the
/// object's own. The custom material has the object's Poisson ratio. Any thread.
double surfaceCompliancePerPa(const Material& own, const ParameterValues& parameters);

/// The chosen mallet as a key has it, on a surface of that compliance [1/Pa]; 0 is rigid. The
/// custom mallet's hardness is the modulus of the whole contact, whatever it meets. A mallet that
/// follows the keys by a share q has a contact of pitchRatio^(q (p+1)) times the modulus, so its
/// contact time on something heavy falls as pitchRatio^q. Any thread.
Striker
striker(const KeyMallet& key, const ParameterValues& parameters, double surfaceCompliance = 0);

/// The speed [m/s] of a mallet at MIDI velocity 1 to 127. Any thread.
double malletSpeedAt(int velocity, const ParameterValues& parameters);

/// The strike of a mallet at a speed > 0 on what yields as `driven` does, into the surface. Any
/// thread.
Strike malletStrike(const StrikePoint& point,
                    const Striker& mallet,
                    double speedMetresPerSecond,
                    const DrivingPoint& driven);

/// The same of the chosen mallet on an object of an instrument, under the parameters' material,
/// size and thickness. Any thread.
Strike malletStrike(const StrikePoint& point,
                    int velocity,
                    const KeyMallet& key,
                    const ParameterValues& parameters,
                    const SynthesiserSlot& struck);

} // namespace idiophone
