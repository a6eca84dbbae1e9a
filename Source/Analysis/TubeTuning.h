// Tunes tubular bells: finds the length of an open tube, a two-layer shell, for a perceived pitch.
// No mode of a tubular bell has that pitch; the lowest mode of a short chime has it.
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
    std::string source; ///< for the object's provenance
    double noteFrequencyHz = 261.626;
    int tunedMode = 4; ///< 4: an octave above the note, as on chimes; 1: at the note
    double outerDiameterMetres = 0.038;
    double wallMetres = 0.0015;
    int rows = 240; ///< of the mesh, a multiple of 8: the higher the closer the triangles
    Material material;
    double maxFrequencyHz = 8000;
    int shapeVertexCount = 44; ///< on the side towards the listener, +y
};

struct TunedTube {
    double lengthMetres = 0;
    std::array<double, 6> bendingHz{}; ///< damped, modes 1 to 6, each a pair; at least two above
                                       ///< the tuned one, else 0
    ModalObject object;                ///< along z, its middle at the origin
};

/// Tunes the mode to within 0.1 cent. Errors: impossible dimensions, missing bending modes,
/// `cancelledMessage`.
Result<TunedTube> tuneTube(const TubeSpecification& tube, const WorkControl& control = {});

/// Returns the length at which the tuned mode of a slender free tube has this frequency (Euler and
/// Bernoulli).
double slenderTubeLengthMetres(const TubeSpecification& tube, double modeHz);

} // namespace idiophone
