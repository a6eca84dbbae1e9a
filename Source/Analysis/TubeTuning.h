// Tubes in tune: solves the length of an open tube, a two-layer shell, for the pitch that is heard
// of a tubular bell, which none of its modes has.
#pragma once

#include "Object/ModalObject.h"
#include "Object/WorkControl.h"

#include <array>
#include <string>

namespace idiophone {

/// Bending modes 4, 5 and 6 of a tube lie near 2 : 3 : 4; the ear takes them for the harmonics of a
/// tone an octave below mode 4 (Rossing), which is the note.
struct TubeSpecification {
    std::string name;
    std::string source;               ///< for the object's provenance
    double noteFrequencyHz = 261.626; ///< mode 4 goes to twice that
    double outerDiameterMetres = 0.038;
    double wallMetres = 0.0015;
    Material material;
    double maxFrequencyHz = 8000;
    int shapeVertexCount = 44; ///< of the side towards the listener, +y
};

struct TunedTube {
    double lengthMetres = 0;
    std::array<double, 6> bendingHz{}; ///< damped, of modes 1 to 6; each is a pair
    ModalObject object;                ///< along z, its middle at the origin
};

/// Mode 4 is met within 0.1 cent. Errors: measures that no tube has, or whose bending modes are not
/// found; `cancelledMessage`.
Result<TunedTube> tuneTube(const TubeSpecification& tube, const WorkControl& control = {});

/// The length at which mode 4 of a slender free tube has this frequency (Euler and Bernoulli).
double slenderTubeLengthMetres(const TubeSpecification& tube, double modeFourHz);

} // namespace idiophone
