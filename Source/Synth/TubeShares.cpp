#include "Synth/TubeShares.h"

#include "Synth/ModeCompression.h"

#include <algorithm>
#include <complex>
#include <cstddef>

namespace idiophone {

namespace {

using Complex = std::complex<double>;

bool haveOneShape(const ModalObject& object, std::size_t a, std::size_t b) {
    for (std::size_t row = 0; row < object.shapeVertexCount(); ++row) {
        const auto shapes = object.shapesAt(row);
        if (!std::ranges::equal(shapes.subspan(3 * a, 3), shapes.subspan(3 * b, 3)))
            return false;
    }
    return true;
}

/// Of mode `a`, whose other one is `b`, where the object has its reference size and pitch.
double tubeShare(const ModalObject& object, std::size_t a, std::size_t b) {
    std::vector<std::complex<float>> weights(object.modeCount());
    double ofTube = 0, ofAll = 0;
    for (std::size_t direction = 0; direction < object.radiation.directions.size(); ++direction) {
        object.radiation.weightsAt(direction, 1, weights);
        const Complex all(weights[a]), other(weights[b]);
        const Complex gain(object.gains[a]), otherGain(object.gains[b]);
        const Complex tube = all - gain * (all + other) / (gain + otherGain);
        ofTube += (tube * std::conj(all)).real();
        ofAll += std::norm(all);
    }
    return ofAll > 0 ? ofTube / ofAll : 0;
}

} // namespace

std::vector<float> tubeShares(const ModalObject& object) {
    std::vector<float> shares;
    if (object.gains.empty())
        return shares;
    for (std::size_t mode = 0; mode < object.modeCount(); ++mode)
        shares.push_back(isShared(object.gains, mode) ? 1.0f : 0.0f);
    if (object.radiation.empty())
        return shares;
    for (std::size_t a = 0; a < shares.size(); ++a)
        for (std::size_t b = a + 1; b < shares.size(); ++b)
            if (isShared(object.gains, a) && isShared(object.gains, b) &&
                std::abs(object.gains[a] + object.gains[b]) > 0.5f && haveOneShape(object, a, b)) {
                shares[a] = static_cast<float>(tubeShare(object, a, b));
                shares[b] = static_cast<float>(tubeShare(object, b, a));
            }
    return shares;
}

} // namespace idiophone
