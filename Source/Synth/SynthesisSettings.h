// What may change while objects ring. All of it acts at grid points.
#pragma once

#include "Object/Material.h"

#include <limits>
#include <optional>

namespace idiophone {

/// Every object renders in cells of this many samples, counted on the stream from its start.
inline constexpr int cellSamples = 64;

/// The surface velocity, in m/s, that one unit of τ stands for: τ counts 16-bit steps of a full
/// scale of 65536 (Raghuvanshi & Lin 2006, section 4.2), and full scale is 1 m/s.
inline constexpr double metresPerSecondPerTau = 1.0 / 65536.0;

/// A material that replaces each object's own while it is played.
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

/// A figure out of its range is ignored and keeps what it was. Frequency, size and material all act
/// on the eigenvalues: λ = λ_ref · (Y/ρ)/(Y₀/ρ₀) / size² · frequencyRatio² (where a pitch is kept,
/// frequencyRatio alone), and the damping
/// d = γ + χ √λ + η λ follows the λ that results. Strikes are divided by the mass, ∝ ρ · size³. The
/// thickness acts on objects that have it live (ModalObject::eigenvalueAt), and on their mass.
struct SynthesisSettings {
    double tau = 0.01;        ///< τ ≥ 0 in 16-bit steps; 0 never truncates
    double qualitySlope = 1;  ///< S ≥ 0; infinity is greedy
    double modeBudget = 4096; ///< Q ≥ 0: modes mixed per cell by all objects together
    double compression = 1;   ///< ≥ 0, times the discrimination curve; 0 merges equal poles only
    double sizeRatio = 1;     ///< 1e-6 to 1e6: every object scaled by this
    /// 0.1 to 10: every shell that can so many times as thick as it was analysed.
    double thicknessRatio = 1;
    double frequencyRatio = 1; ///< > 0: every frequency times this (tuning, bend)
    /// Slots with a pitch (SynthesiserSlot) keep it under any material, size and thickness.
    bool keepPitch = false;
    /// 0 to 1: from what is heard at the point struck to what the whole surface radiates to
    /// the listener, where the object knows; for strikes from now on. What is radiated is scaled
    /// for each object to be about as loud as near: not to be compared between objects.
    double radiation = 0;
    /// Of every slot that has none of its own (Synthesiser::setMaterial); nothing: its object's.
    std::optional<LiveMaterial> material = {};

    bool operator==(const SynthesisSettings&) const = default;
};

inline constexpr double greedySlope = std::numeric_limits<double>::infinity();

} // namespace idiophone
