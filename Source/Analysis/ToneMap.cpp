#include "Analysis/ToneMap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

constexpr double slowestDecayPerSecond = 0.0115; // ln(1000) in ten minutes
// In α_ij. Beyond this distance, two modes contribute less than −30 dB to each other.
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
            if (apart > farthestApart * (tones[i].decayPerSecond + fastest))
                break;
            const double decay = tones[i].decayPerSecond + tones[j].decayPerSecond;
            if (apart <= farthestApart * decay)
                use(i, j, decay / (decay * decay + apart * apart) / 2);
        }
}

/// Vertices whose sums are computed together.
constexpr std::size_t rowsTogether = 8;
using OfRows = std::array<double, rowsTogether>;

/// Returns (φ · n)² of each tone at some shape vertices. Unused entries are 0.
std::vector<OfRows> gainsOf(const std::vector<Tone>& tones,
                            const ModalObject& object,
                            const std::vector<float>& normals,
                            std::size_t firstRow) {
    std::vector<OfRows> gains(tones.size());
    const auto count = std::min(rowsTogether, object.shapeVertexCount() - firstRow);
    for (std::size_t k = 0; k < count; ++k) {
        const auto shapes = object.shapesAt(firstRow + k);
        const float* normal =
            &normals[static_cast<std::size_t>(object.shapeVertices[firstRow + k]) * 3];
        for (std::size_t i = 0; i < tones.size(); ++i) {
            double along = 0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                along += static_cast<double>(shapes[3 * tones[i].mode + axis]) *
                         static_cast<double>(normal[axis]);
            gains[i][k] = along * along;
        }
    }
    return gains;
}

} // namespace

std::vector<double> brightnessHz(const ModalObject& object, const std::vector<float>& normals) {
    const auto tones = audibleTones(object);
    std::vector<double> result(object.shapeVertexCount());
    for (std::size_t firstRow = 0; firstRow < result.size(); firstRow += rowsTogether) {
        const auto gains = gainsOf(tones, object, normals, firstRow);
        OfRows energy{}, moment{};
        forEachCoupling(tones, [&](std::size_t i, std::size_t j, double each) {
            const double both = (i == j ? 1 : 2) * each;
            const double frequencies = tones[i].frequencyHz + tones[j].frequencyHz;
            const auto &one = gains[i], &other = gains[j];
            for (std::size_t k = 0; k < rowsTogether; ++k) {
                const double shared = both * one[k] * other[k];
                energy[k] += shared;
                moment[k] += shared * frequencies / 2;
            }
        });
        const auto count = std::min(rowsTogether, result.size() - firstRow);
        for (std::size_t k = 0; k < count; ++k)
            result[firstRow + k] = energy[k] > 0 ? moment[k] / energy[k] : 0;
    }
    return result;
}

} // namespace idiophone
