// SPDX-License-Identifier: Apache-2.0
// Settings that may change while objects ring. They act at grid points.
#pragma once

#include "Object/Material.h"

#include <limits>
#include <optional>

namespace idiophone {

/// Every resonator renders in cells of this many samples, counted from the start of the stream.
inline constexpr int cellSamples = 64;

/// The pressure of one unit of τ. τ counts 16-bit steps of a full scale of 65536 (Raghuvanshi & Lin
/// 2006, section 4.2), and full scale is 1 Pa.
inline constexpr double pascalsPerTau = 1.0 / 65536.0;

/// A material that replaces each object's own during play.
struct LiveMaterial {
    double youngsModulusPa = 0;
    double densityKgPerM3 = 0;
    DampingLaw damping;

    bool operator==(const LiveMaterial&) const = default;
};

inline LiveMaterial liveMaterial(const Material& material) noexcept {
    return {.youngsModulusPa = material.youngsModulusPa,
            .densityKgPerM3 = material.densityKgPerM3,
            .damping = material.damping};
}

/// A value out of range is ignored and the previous one kept. Frequency, size and material act on
/// the eigenvalues: λ = λ_ref · (Y/ρ)/(Y₀/ρ₀) / size² · frequencyRatio². If a pitch is kept, only
/// frequencyRatio acts. The damping d = γ + χ √λ + η λ follows the resulting λ. Strikes are divided
/// by the mass, ∝ ρ · size³. The thickness acts on objects with live thickness
/// (ModalObject::eigenvalueAt), and on their mass.
struct SynthesisSettings {
    double tau = 0.01;        ///< τ ≥ 0 in 16-bit steps; 0 never truncates
    double qualitySlope = 1;  ///< S ≥ 0; infinity is greedy
    double modeBudget = 4096; ///< Q ≥ 0: modes mixed per cell by all objects together
    double compression = 1; ///< ≥ 0, factor of the discrimination curve; 0 merges equal poles only
    double sizeRatio = 1;   ///< 1e-6 to 1e6: scales every object
    /// 0.1 to 10: thickness over the analysed one, for every shell with live thickness.
    double thicknessRatio = 1;
    /// 0 to 0.01: relative frequency difference within pairs of modes (Imperfection.h).
    double imperfection = 0;
    double frequencyRatio = 1; ///< > 0: multiplies every frequency (tuning, bend)
    double decayRatio = 1;     ///< 0.01 to 100: multiplies the time in which every mode decays
    /// Slots with a pitch (SynthesiserSlot) keep it under any material, size and thickness.
    bool keepPitch = false;
    /// 0 (contact microphone at the struck point) to 1 (pressure that the whole surface radiates at
    /// 1 m, if the object has a radiation table). Applies to strikes from now on.
    double radiation = 0;
    /// Material of every slot without its own (Synthesiser::setMaterial); empty: the object's.
    std::optional<LiveMaterial> material = {};

    bool operator==(const SynthesisSettings&) const = default;
};

/// Returns the settings; values out of range keep the previous ones.
SynthesisSettings corrected(SynthesisSettings wanted, const SynthesisSettings& previous) noexcept;
bool valid(const LiveMaterial& material) noexcept;

inline constexpr double greedySlope = std::numeric_limits<double>::infinity();

} // namespace idiophone
