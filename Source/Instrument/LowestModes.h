// The lowest modes of the objects that keys play, moved to the frequencies at which they sound now.
#pragma once

#include "Object/ModalObject.h"

#include <array>
#include <cstddef>
#include <span>

namespace idiophone {

/// The lowest eight frequencies of an object. Modes within 1 % of the previous one, such as the
/// pairs of a round object, count once. The selection is made at the analysed thickness.
struct LowestModes {
    static constexpr std::size_t capacity = 8;

    std::array<double, capacity> frequenciesHz{};
    std::array<ModeDamping, capacity> dampings{};
    /// Share of each λ that grows with the square of a shell's thickness, 0 to 1.
    std::array<double, capacity> bendingShares{};
    std::size_t count = 0;

    LowestModes() = default;
    /// Takes the modes at the reference material, thickness and size.
    explicit LowestModes(const ModalObject& object);

    /// Returns the modes at `thicknessRatio` > 0 times the shell's thickness, as in
    /// ModalObject::eigenvalueAt. Without live thickness they stay the same. Does not allocate.
    LowestModes atThickness(double thicknessRatio) const;

    /// Returns the frequencies times `ratio`, at least 20 Hz, because nothing sounds below. Does
    /// not allocate.
    LowestModes moved(double ratio) const;

    std::span<const double> span() const { return std::span(frequenciesHz).first(count); }
};

} // namespace idiophone
