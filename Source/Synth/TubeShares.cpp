// SPDX-License-Identifier: Apache-2.0
#include "Synth/TubeShares.h"

#include <complex>
#include <cstddef>

namespace idiophone {

namespace {

using Complex = std::complex<double>;

/// Returns the tube's share of mode `a`, whose partner is `b`, at the object's reference size and
/// pitch.
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
    for (std::size_t mode = 0; !object.gains.empty() && mode < object.modeCount(); ++mode) {
        shares.push_back(object.isShared(mode) ? 1.0f : 0.0f);
        if (const auto partner = sharingPartner(object, mode); partner && !object.radiation.empty())
            shares.back() = static_cast<float>(tubeShare(object, mode, *partner));
    }
    return shares;
}

} // namespace idiophone
