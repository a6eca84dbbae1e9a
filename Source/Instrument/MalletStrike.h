// From a key's velocity and the mallet's parameters to a contact: where, how hard, how long.
#pragma once

#include "Instrument/StrikePlace.h"
#include "Object/Material.h"
#include "Parameters/ParameterTable.h"
#include "Synth/Strike.h"

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

/// The strike of the chosen mallet at MIDI velocity 1 to 127: impulse m v, contact time after Hertz
/// (Mallet.h). A mallet of the rack meets a surface of that compliance, 0 being rigid; the custom
/// mallet's hardness is the modulus of the whole contact, whatever it meets. A mallet scaled by s
/// has s³ its mass and s times its contact time at the same speed. Any thread.
Strike malletStrike(const StrikePoint& point,
                    int velocity,
                    double malletScale,
                    const ParameterValues& parameters,
                    double surfaceCompliance = 0);

} // namespace idiophone
