// The modes of a slot as they are heard after impulses at points of its object.
#pragma once

#include "Instrument/SettingsOfParameters.h"
#include "Synth/ComplexProduct.h"
#include "Synth/Listening.h"
#include "Synth/LiveConditions.h"
#include "Synth/PointShapes.h"
#include "Synth/Synthesiser.h"

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <span>

namespace idiophone {

/// A point of a surface and the force that acts there for each newton.
struct PushedPoint {
    StrikePoint point;
    std::array<float, 3> push{};
};

/// How a slot sounds under settings.
struct SlotHearing {
    SlotHearing() = default;
    SlotHearing(const SynthesiserSlot& slot, const SynthesisSettings& settings) noexcept
        : conditions(liveConditions(slot, settings)),
          thicknessRatio(slot.object->hasLiveThickness() ? settings.thicknessRatio : 1),
          farShare(slot.object->radiation.empty() ? 0 : settings.radiation) {
        conditions.gainRatio /= thicknessRatio;
        conditions.radiationGainRatio /= thicknessRatio;
    }

    LiveConditions conditions;
    double thicknessRatio = 1;
    double farShare = 0; ///< share of the far sound, 0 to 1
};

/// Calls `add(pole, residues)` for each mode of the object that sounds, in ascending order. The
/// residues, left and right for each point, are the complex velocities that 1 N s leaves. At most
/// `most` points. Does not allocate.
template <std::size_t most, class Add>
void forEachHeardMode(const ModalObject& object,
                      const SlotHearing& hearing,
                      std::span<const PushedPoint> points,
                      double sampleRateHz,
                      const Add& add) noexcept {
    constexpr std::size_t chunk = 16;
    const auto& conditions = hearing.conditions;
    const auto near = static_cast<float>(contactMicrophonePascals * conditions.gainRatio);
    const auto far = static_cast<float>(conditions.radiationGainRatio);
    for (std::size_t first = 0; first < object.modeCount(); first += chunk) {
        const std::size_t count = std::min(chunk, object.modeCount() - first);
        std::array<std::array<float, chunk>, most> struck, heard;
        for (std::size_t at = 0; at < points.size(); ++at)
            projectShapes(pointShapes(object, points[at].point, first), points[at].push,
                          listeningDirection(points[at].point), count, struck[at].data(),
                          heard[at].data());
        std::array<std::array<std::complex<float>, chunk>, 2> radiated{};
        if (hearing.farShare > 0)
            for (std::size_t channel = 0; channel < radiated.size(); ++channel)
                object.radiation.weightsAt(
                    std::min(channel, object.radiation.directions.size() - 1),
                    conditions.radiationRatio, std::span(radiated[channel]).first(count), first);
        for (std::size_t i = 0; i < count; ++i) {
            const auto pole = conditions.law.pole(
                object.eigenvalueAt(first + i, hearing.thicknessRatio), object.damping(first + i));
            if (!soundsAt(pole, sampleRateHz))
                continue;
            std::array<std::array<std::complex<double>, 2>, most> residues{};
            for (std::size_t at = 0; at < points.size(); ++at)
                for (std::size_t channel = 0; channel < radiated.size(); ++channel)
                    residues[at][channel] =
                        phasorBetween(near * struck[at][i] * heard[at][i] *
                                          (object.gains.empty() ? 1.0f : object.gains[first + i]),
                                      far * struck[at][i] * radiated[channel][i],
                                      static_cast<float>(hearing.farShare));
            add(pole, residues);
        }
    }
}

} // namespace idiophone
