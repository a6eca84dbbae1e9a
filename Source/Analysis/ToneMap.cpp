#include "Analysis/ToneMap.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace idiophone {
namespace {

constexpr double slowestDecayPerSecond = 0.0115; // ln(1000) in ten minutes
// In α_ij: farther apart, what two modes add to one another is below −30 dB.
constexpr double farthestApart = 32;

struct Tone {
    std::size_t mode = 0;
    double frequencyHz = 0;
    double decayPerSecond = 0;
};

std::vector<Tone> audibleTones(const ModalObject& object) {
    std::vector<Tone> tones;
    for (std::size_t mode = 0; mode < object.modeCount(); ++mode) {
        const double decay = object.decayPerSecond(mode);
        const double frequencyHz = object.dampedFrequencyHz(mode);
        if (frequencyHz >= lowestToneHz && frequencyHz <= highestToneHz)
            tones.push_back({.mode = mode,
                             .frequencyHz = frequencyHz,
                             .decayPerSecond = std::max(decay, slowestDecayPerSecond)});
    }
    std::ranges::sort(tones, {}, &Tone::frequencyHz);
    return tones;
}

/// ½ α_ij / (α_ij² + Δ_ij²) of two tones, where that counts.
struct Coupling {
    std::size_t i = 0, j = 0;
    double energy = 0;
};

std::vector<Coupling> couplings(const std::vector<Tone>& tones) {
    double fastest = 0;
    for (const auto& tone : tones)
        fastest = std::max(fastest, tone.decayPerSecond);
    std::vector<Coupling> result;
    for (std::size_t i = 0; i < tones.size(); ++i)
        for (std::size_t j = i; j < tones.size(); ++j) {
            const double apart =
                2 * std::numbers::pi * (tones[j].frequencyHz - tones[i].frequencyHz);
            if (apart > farthestApart * (tones[i].decayPerSecond + fastest))
                break;
            const double decay = tones[i].decayPerSecond + tones[j].decayPerSecond;
            if (apart <= farthestApart * decay)
                result.push_back({i, j, decay / (decay * decay + apart * apart) / 2});
        }
    return result;
}

/// (φ · n)² of each tone.
void findGains(const std::vector<Tone>& tones,
               std::span<const float> shapes,
               const float* normal,
               std::vector<double>& gains) {
    for (std::size_t i = 0; i < tones.size(); ++i) {
        double along = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            along += static_cast<double>(shapes[3 * tones[i].mode + axis]) *
                     static_cast<double>(normal[axis]);
        gains[i] = along * along;
    }
}

} // namespace

std::vector<double> brightnessHz(const ModalObject& object, const std::vector<float>& normals) {
    const auto tones = audibleTones(object);
    const auto coupled = couplings(tones);
    std::vector<double> gains(tones.size()), result(object.shapeVertexCount());
    for (std::size_t row = 0; row < result.size(); ++row) {
        findGains(tones, object.shapesAt(row),
                  &normals[static_cast<std::size_t>(object.shapeVertices[row]) * 3], gains);
        double energy = 0, moment = 0;
        for (const auto& [i, j, each] : coupled) {
            const double shared = (i == j ? 1 : 2) * each * gains[i] * gains[j];
            energy += shared;
            moment += shared * (tones[i].frequencyHz + tones[j].frequencyHz) / 2;
        }
        result[row] = energy > 0 ? moment / energy : 0;
    }
    return result;
}

} // namespace idiophone
