// The tines, teeth and tongues of the factory instruments before tuning: bars that are held at one
// end. docs/instruments.md lists the sources of their dimensions.
#pragma once

#include "Analysis/BarTuning.h"

namespace idiophone {

// `keyboardShare` is 0 at the lowest key and 1 at the highest.

/// A flat steel tine over a bridge, on a wooden box.
BarSpecification kalimbaTine(double frequencyHz, double keyboardShare);
/// A tooth of a steel comb.
BarSpecification musicBoxTooth(double frequencyHz, double keyboardShare);
/// A tongue cut into a drum of sheet steel.
BarSpecification steelTongue(double frequencyHz, double keyboardShare);
/// A tongue sawn into the lid of a wooden box.
BarSpecification woodenTongue(double frequencyHz, double keyboardShare);
/// The reed of a jaw harp, without its frame and the player's mouth.
BarSpecification jawHarpReed(double frequencyHz, double keyboardShare);

} // namespace idiophone
