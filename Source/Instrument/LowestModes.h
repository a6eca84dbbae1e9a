// The lowest modes of the objects that keys play, at the frequencies they sound now.
#pragma once

#include "Object/ModalObject.h"
#include "Synth/SynthesisSettings.h"

#include <array>
#include <cstddef>
#include <span>

namespace idiophone {

/// The lowest eight frequencies of an object; modes within 1 % of the one before, as the pairs of a
/// round object, count once.
struct LowestModes {
    static constexpr std::size_t capacity = 8;

    std::array<double, capacity> frequenciesHz{};
    std::array<double, capacity> dampingScales{}; ///< ModalObject::dampingScale
    std::size_t count = 0;

    LowestModes() = default;
    /// At the reference material, scaled by `sizeRatio` > 0.
    LowestModes(const ModalObject& object, double sizeRatio);

    /// These times `ratio`, none below 20 Hz, where nothing sounds. Does not allocate.
    LowestModes moved(double ratio) const;

    std::span<const double> span() const { return std::span(frequenciesHz).first(count); }
};

/// By what the settings multiply the frequencies of an object of this material. Does not allocate.
double liveFrequencyRatio(const Material& own, const SynthesisSettings& settings);

} // namespace idiophone
