#include "Instrument/DecayBounds.h"

#include "Parameters/ParameterTable.h"
#include "Synth/LiveConditions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace idiophone {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

DampingLaw
each(const DampingLaw& a, const DampingLaw& b, double (*choose)(double, double)) noexcept {
    return {.fluidPerSecond = choose(a.fluidPerSecond, b.fluidPerSecond),
            .viscoelasticSeconds = choose(a.viscoelasticSeconds, b.viscoelasticSeconds),
            .lossFactor = choose(a.lossFactor, b.lossFactor)};
}

double lesser(double a, double b) noexcept {
    return std::min(a, b);
}

double greater(double a, double b) noexcept {
    return std::max(a, b);
}

/// λ of the lowest mode of a slot that keeps its pitch, at the reference thickness and at any. Over
/// the pitch's λ, each mode's is a ratio of two linear functions of the thickness squared, so its
/// minimum lies at an end of the range.
struct LowestKept {
    double atReference = 0, atAnyThickness = 0;
};

LowestKept lowestKept(const ModalObject& object, const PitchMode& pitch) {
    const auto& range = parameterInfo(ParameterId::thickness);
    const double omega = 2 * std::numbers::pi * pitch.hz;
    const auto lowestAt = [&](double thicknessRatio) {
        double lowest = infinity;
        for (std::size_t mode = 0; mode < object.modeCount(); ++mode)
            lowest = std::min(lowest, object.eigenvalueAt(mode, thicknessRatio));
        const double bent = (thicknessRatio * thicknessRatio - 1) * pitch.bending;
        return omega * omega * lowest / (pitch.eigenvalue + bent);
    };
    const double atReference = lowestAt(1);
    if (!object.hasLiveThickness())
        return {atReference, atReference};
    return {atReference,
            std::min({atReference, lowestAt(range.minimum / 100), lowestAt(range.maximum / 100)})};
}

double lowestWithKeptPitch(const DecayBounds& bounds, const SynthesisSettings& settings) noexcept {
    return settings.thicknessRatio == 1 ? bounds.lowestKept : bounds.lowestKeptAtAnyThickness;
}

double lowestOfMaterial(const DecayBounds& bounds, const SynthesisSettings& settings) noexcept {
    const auto& live = settings.material;
    const double thin = std::min(settings.thicknessRatio, 1.0);
    const double material = live ? live->youngsModulusPa / live->densityKgPerM3 : 1;
    return material * (live ? bounds.lowestOfUnitMaterial : bounds.lowestEigenvalue) *
           (1 + (thin * thin - 1) * bounds.mostBending) / (settings.sizeRatio * settings.sizeRatio);
}

} // namespace

DecayBounds decayBounds(const Instrument& instrument, RingingKeys keys) {
    DecayBounds bounds{.lowestEigenvalue = infinity,
                       .lowestOfUnitMaterial = infinity,
                       .lowestKept = infinity,
                       .lowestKeptAtAnyThickness = infinity,
                       .least = {infinity, infinity, infinity},
                       .most = {},
                       .leastScale = infinity,
                       .mostScale = 0};
    const auto slots = instrument.slots();
    std::vector<bool> isResized(slots.size(), false);
    for (int note = 0; note < 128; ++note)
        if (const auto& key = instrument.key(note); key.slot >= 0 && !key.isOwn)
            isResized[static_cast<std::size_t>(key.slot)] = true;
    for (std::size_t index = 0; index < slots.size(); ++index) {
        if (keys == RingingKeys::own && isResized[index])
            continue;
        const auto& slot = slots[index];
        const auto& object = *slot.object;
        const auto& material = object.material;
        if (object.modeCount() == 0)
            continue;
        const double lowest = object.eigenvalues.front() / (slot.sizeRatio * slot.sizeRatio);
        bounds.lowestEigenvalue = std::min(bounds.lowestEigenvalue, lowest);
        bounds.lowestOfUnitMaterial =
            std::min(bounds.lowestOfUnitMaterial,
                     lowest * material.densityKgPerM3 / material.youngsModulusPa);
        const auto kept = slot.pitch ? lowestKept(object, *slot.pitch) : LowestKept{};
        bounds.lowestKept = std::min(bounds.lowestKept, kept.atReference);
        bounds.lowestKeptAtAnyThickness =
            std::min(bounds.lowestKeptAtAnyThickness, kept.atAnyThickness);
        bounds.least = each(bounds.least, material.damping, lesser);
        bounds.most = each(bounds.most, material.damping, greater);
        for (std::size_t mode = 0; mode < object.modeCount(); ++mode) {
            const double scale = object.dampingScale(mode);
            bounds.leastScale = std::min(bounds.leastScale, scale);
            bounds.mostScale = std::max(bounds.mostScale, scale);
            if (object.hasLiveThickness())
                bounds.mostBending =
                    std::max(bounds.mostBending, object.bending[mode] / object.eigenvalues[mode]);
        }
    }
    return bounds;
}

double slowestDecay(const DecayBounds& bounds,
                    const SynthesisSettings& settings,
                    double semitonesBelow) noexcept {
    const auto& live = settings.material;
    const double tuning = settings.frequencyRatio * std::exp2(-semitonesBelow / 12);
    constexpr double lowestOmega = 2 * std::numbers::pi * lowestSoundingHz;
    const double lowest = settings.keepPitch && bounds.lowestKept > 0
                              ? lowestWithKeptPitch(bounds, settings)
                              : lowestOfMaterial(bounds, settings);
    // Of the lowest mode; what lies below the band does not sound.
    const double eigenvalue = std::max(lowest * tuning * tuning, lowestOmega * lowestOmega);
    if (!std::isfinite(eigenvalue))
        return infinity;
    const double least =
        bounds.leastScale * (live ? live->damping : bounds.least).perSecond(eigenvalue);
    const double most =
        bounds.mostScale * (live ? live->damping : bounds.most).perSecond(eigenvalue);
    // All laws damp higher modes more: a mode that oscillates has at least d/2. The slower root of
    // one that is over-damped is above λ/d, and that grows with λ too.
    return std::min(least / 2, eigenvalue / most);
}

double semitonesBelowEqual(const Instrument& instrument, const KeyTuning& tuning) {
    double below = 0;
    if (!instrument.keysHaveObjects())
        return below;
    for (int note = 0; note < KeyTuning::notes; ++note)
        if (const auto index = static_cast<std::size_t>(note);
            instrument.key(note).slot >= 0 && !tuning.unmapped[index])
            below = std::max(below, -tuning.semitonesFromEqual[index]);
    return below;
}

} // namespace idiophone
