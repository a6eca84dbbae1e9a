// Tunes tubular bells: finds the length of an open tube, a two-layer shell, for a perceived pitch.
// No mode of the tube has that pitch.
#pragma once

#include "Object/ModalObject.h"
#include "Object/WorkControl.h"

#include <array>
#include <string>

namespace idiophone {

/// Bending modes 4, 5 and 6 of a tube lie near 2 : 3 : 4. The ear hears them as harmonics of a tone
/// an octave below mode 4 (Rossing). That tone is the note.
struct TubeSpecification {
    std::string name;
    std::string source;               ///< for the object's provenance
    double noteFrequencyHz = 261.626; ///< half of mode 4's frequency
    double outerDiameterMetres = 0.038;
    double wallMetres = 0.0015;
    Material material;
    double maxFrequencyHz = 8000;
    int shapeVertexCount = 44; ///< on the side towards the listener, +y
};

struct TunedTube {
    double lengthMetres = 0;
    std::array<double, 6> bendingHz{}; ///< damped, modes 1 to 6; each is a pair
    ModalObject object;                ///< along z, its middle at the origin
};

/// Tunes mode 4 to within 0.1 cent. Errors: impossible dimensions, missing bending modes,
/// `cancelledMessage`.
Result<TunedTube> tuneTube(const TubeSpecification& tube, const WorkControl& control = {});

/// Returns the length at which mode 4 of a slender free tube has this frequency (Euler and
/// Bernoulli).
double slenderTubeLengthMetres(const TubeSpecification& tube, double modeFourHz);

} // namespace idiophone
