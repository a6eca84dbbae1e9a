// SPDX-License-Identifier: Apache-2.0
// The modes of an object that yield most at one place, for a contact that depends on the motion of
// the place sample by sample.
#pragma once

#include "Synth/ForceCell.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace idiophone {

class ModePoles;
struct ChannelResidues;

/// The motion is the velocity along the direction of the place's force. The mode of state s
/// moves with Re s. In a sample the state turns by `rotation`; an impulse of 1 N s adds `push` to
/// it. Modes from `count` on are 0.
struct PointModes {
    static constexpr std::size_t capacity = 32;

    /// All that the modes depend on.
    struct Source {
        const void* owner = nullptr; ///< the resonator
        std::uint64_t version = 0;   ///< of its poles
        double perMass = 0;          ///< 1 over the mass ratio
        ForcePlace place;

        bool operator==(const Source&) const = default;
    };

    Source source;
    std::size_t count = 0;
    std::array<std::int32_t, capacity> numbers{}; ///< modes of the object, ascending
    /// The angle in which a sample turns the mode that yields most to a steady force; 0 without
    /// modes.
    double softestRadians = 0;
    alignas(64) std::array<float, capacity> rotationRe{}, rotationIm{};
    alignas(64) std::array<float, capacity> pushRe{}, pushIm{}; ///< in 1/kg

    /// Returns the step of the velocity after an impulse of 1 N s, in 1/kg.
    double mobilityPerKg() const noexcept;
};

/// Replaces the modes by those groups in the band whose velocity under a force at their own
/// frequency, |r|/α, is largest. `residues` r [G] are those of the place, heard at the place
/// itself; those of higher modes count less over a contact's width (ContactWidth). `starts` [G+1]
/// are the first modes of the groups. Neither allocates nor throws.
void takeStrongest(const ModePoles& poles,
                   std::span<const std::int32_t> starts,
                   const ChannelResidues& residues,
                   PointModes& modes) noexcept;

} // namespace idiophone
