#include "Analysis/FactoryBars.h"

#include <cmath>

namespace idiophone {
namespace {

// Derived: lengths from 385 mm down to 140 mm, all within the measures of real xylophones.
constexpr double lowestWidthMetres = 0.040, highestWidthMetres = 0.030;
constexpr double lowestHeightMetres = 0.020, highestHeightMetres = 0.0235;

Material rosewood() {
    Material material = *findMaterial("Rosewood");
    material.poissonRatio = 1.0 / 3; // what the springs make of it
    return material;
}

} // namespace

double noteFrequencyHz(int midiNote) {
    return 440 * std::exp2((midiNote - 69) / 12.0);
}

BarSpecification rosewoodXylophoneBar(int midiNote) {
    const double share = static_cast<double>(midiNote - lowestXylophoneNote) /
                         (highestXylophoneNote - lowestXylophoneNote);
    return {.name = "xylophone-" + std::to_string(midiNote),
            .targetFrequencyHz = noteFrequencyHz(midiNote),
            .widthMetres = std::lerp(lowestWidthMetres, highestWidthMetres, share),
            .heightMetres = std::lerp(lowestHeightMetres, highestHeightMetres, share),
            .material = rosewood()};
}

} // namespace idiophone
