// SPDX-License-Identifier: Apache-2.0
#include "Synth/PointModes.h"

#include "Synth/ContactWidth.h"
#include "Synth/LiveConditions.h"
#include "Synth/ModePoles.h"
#include "Synth/ModeResidues.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

namespace idiophone {
namespace {

constexpr double slowestDecay = 1e-3; // [1/s]

struct Candidate {
    double yield = 0;
    std::size_t group = 0;
};

/// The strongest candidates so far: a heap with the weakest on top.
class Strongest {
public:
    void offer(const Candidate& candidate) noexcept {
        if (used == heap.size() && !(candidate.yield > heap.front().yield))
            return;
        if (used == heap.size())
            std::pop_heap(heap.begin(), heap.end(), isStronger);
        else
            ++used;
        heap[used - 1] = candidate;
        std::push_heap(heap.begin(), end(), isStronger);
    }
    std::span<const Candidate> byGroup() noexcept {
        std::sort(heap.begin(), end(),
                  [](const Candidate& a, const Candidate& b) { return a.group < b.group; });
        return std::span(heap).first(used);
    }

private:
    static bool isStronger(const Candidate& a, const Candidate& b) { return a.yield > b.yield; }
    std::array<Candidate, PointModes::capacity>::iterator end() noexcept {
        return heap.begin() + static_cast<std::ptrdiff_t>(used);
    }

    std::array<Candidate, PointModes::capacity> heap;
    std::size_t used = 0;
};

} // namespace

double PointModes::mobilityPerKg() const noexcept {
    return std::accumulate(pushRe.begin(), pushRe.end(), 0.0);
}

void takeStrongest(const ModePoles& poles,
                   std::span<const std::int32_t> starts,
                   const ChannelResidues& residues,
                   PointModes& modes) noexcept {
    const auto& arrays = poles.arrays();
    const double sampleSeconds = poles.sampleSeconds();
    const auto sizeOf = [&](std::size_t g) {
        return std::hypot(static_cast<double>(residues.re[g]), static_cast<double>(residues.im[g]));
    };
    Strongest strongest;
    for (std::size_t g = 0; g < poles.size(); ++g) {
        const ModalPole pole = poles.pole(g);
        if (!isOscillating(pole) || !soundsAt(pole, 1 / sampleSeconds))
            continue;
        if (const double size = sizeOf(g); size > 0)
            strongest.offer({size / std::max(arrays.decay[g], slowestDecay), g});
    }
    modes.count = 0;
    modes.softestRadians = 0;
    modes.rotationRe = modes.rotationIm = modes.pushRe = modes.pushIm = {};
    const auto chosen = strongest.byGroup();
    double softest = 0;
    for (const auto& [yield, g] : chosen)
        if (const double compliance = sizeOf(g) / poles.pole(g).stiffness; compliance > softest) {
            softest = compliance;
            modes.softestRadians = arrays.frequency[g] * sampleSeconds;
        }
    for (const auto& [yield, g] : chosen) {
        const double radians = arrays.frequency[g] * sampleSeconds;
        const double width = ContactWidth::share(radians / modes.softestRadians);
        const auto rotation = std::exp(std::complex(-arrays.decay[g] * sampleSeconds, radians));
        const auto push = width * width * std::complex<double>(residues.re[g], residues.im[g]) *
                          std::complex(1.0, arrays.velocityShare[g]);
        modes.numbers[modes.count] = starts[g];
        modes.rotationRe[modes.count] = static_cast<float>(rotation.real());
        modes.rotationIm[modes.count] = static_cast<float>(rotation.imag());
        modes.pushRe[modes.count] = static_cast<float>(push.real());
        modes.pushIm[modes.count] = static_cast<float>(push.imag());
        ++modes.count;
    }
}

} // namespace idiophone
