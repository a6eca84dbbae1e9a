#include "Analysis/ToneMap.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

constexpr double slowestDecayPerSecond = 0.0115; // ln(1000) in ten minutes
// In α_ij. Beyond this distance, two modes contribute less than −30 dB to each other.
constexpr double maximumApart = 32;

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

/// Calls `use` with two tones and ½ α_ij / (α_ij² + Δ_ij²), if not negligible. The couplings are
/// not stored, because their number is the square of the modes.
template <class Use>
void forEachCoupling(const std::vector<Tone>& tones, const Use& use) {
    double fastest = 0;
    for (const auto& tone : tones)
        fastest = std::max(fastest, tone.decayPerSecond);
    for (std::size_t i = 0; i < tones.size(); ++i)
        for (std::size_t j = i; j < tones.size(); ++j) {
            const double apart =
                2 * std::numbers::pi * (tones[j].frequencyHz - tones[i].frequencyHz);
            if (apart > maximumApart * (tones[i].decayPerSecond + fastest))
                break;
            const double decay = tones[i].decayPerSecond + tones[j].decayPerSecond;
            if (apart <= maximumApart * decay)
                use(i, j, decay / (decay * decay + apart * apart) / 2);
        }
}

/// [V×tones] (φ · n)² of each tone at the shape vertices.
Eigen::ArrayXXd gainsOf(const std::vector<Tone>& tones,
                        const ModalObject& object,
                        const std::vector<float>& normals) {
    Eigen::ArrayXXd gains(object.shapeVertexCount(), tones.size());
    for (Eigen::Index row = 0; row < gains.rows(); ++row) {
        const auto shapes = object.shapesAt(row);
        const float* normal = &normals[object.shapeVertices[row] * 3];
        for (Eigen::Index i = 0; i < gains.cols(); ++i) {
            double along = 0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                along += static_cast<double>(shapes[3 * tones[i].mode + axis]) *
                         static_cast<double>(normal[axis]);
            gains(row, i) = along * along;
        }
    }
    return gains;
}

} // namespace

std::vector<double> brightnessHz(const ModalObject& object, const std::vector<float>& normals) {
    const auto tones = audibleTones(object);
    const auto gains = gainsOf(tones, object, normals);
    Eigen::ArrayXd energy = Eigen::ArrayXd::Zero(gains.rows()), moment = energy, shared;
    forEachCoupling(tones, [&](std::size_t i, std::size_t j, double each) {
        const double both = (i == j ? 1 : 2) * each;
        const double frequencies = tones[i].frequencyHz + tones[j].frequencyHz;
        shared = both * gains.col(i) * gains.col(j);
        energy += shared;
        moment += shared * frequencies / 2;
    });
    const Eigen::ArrayXd centroids = (energy > 0).select(moment / energy, 0);
    return {centroids.begin(), centroids.end()};
}

} // namespace idiophone
