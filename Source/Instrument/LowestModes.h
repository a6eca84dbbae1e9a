// The lowest modes of the objects that keys play, and how to bring them to the frequencies at which
// they sound now.
#pragma once

#include "Object/ModalObject.h"

#include <array>
#include <cstddef>
#include <span>

namespace idiophone {

/// The lowest eight frequencies of an object; modes within 1 % of the one before, as the pairs of a
/// round object, count once. Which they are is decided at the thickness that was analysed.
struct LowestModes {
    static constexpr std::size_t capacity = 8;

    std::array<double, capacity> frequenciesHz{};
    std::array<double, capacity> dampingScales{}; ///< ModalObject::dampingScale
    /// Of each λ the share that grows with the square of a shell's thickness, 0 to 1.
    std::array<double, capacity> bendingShares{};
    std::size_t count = 0;

    LowestModes() = default;
    /// At the reference material, thickness and size.
    explicit LowestModes(const ModalObject& object);

    /// These of the shell so many times (> 0) as thick, as ModalObject::eigenvalueAt has it; those
    /// of what has no live thickness stay. Does not allocate.
    LowestModes atThickness(double thicknessRatio) const;

    /// These times `ratio`, none below 20 Hz, where nothing sounds. Does not allocate.
    LowestModes moved(double ratio) const;

    std::span<const double> span() const { return std::span(frequenciesHz).first(count); }
};

} // namespace idiophone
