#include "Instrument/DecayBounds.h"

#include "Parameters/ParameterTable.h"
#include "Synth/LiveConditions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

namespace idiophone {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Choose>
DampingLaw each(const DampingLaw& a, const DampingLaw& b, Choose choose) noexcept {
    return {.fluidPerSecond = choose(a.fluidPerSecond, b.fluidPerSecond),
            .viscoelasticSeconds = choose(a.viscoelasticSeconds, b.viscoelasticSeconds),
            .lossFactor = choose(a.lossFactor, b.lossFactor)};
}

/// Returns a bound of both bounds' modes. Every law grows with the frequency, so each figure counts
/// alone.
ModeBound boundOfBoth(const ModeBound& a, const ModeBound& b) noexcept {
    return {.eigenvalue = std::min(a.eigenvalue, b.eigenvalue),
            .scale = std::min(a.scale, b.scale),
            .extraPerSecond = std::min(a.extraPerSecond, b.extraPerSecond),
            .specificStiffness = std::max(a.specificStiffness, b.specificStiffness),
            .law = each(a.law, b.law, std::ranges::min)};
}

bool bounds(const ModeBound& slower, const ModeBound& faster) noexcept {
    return boundOfBoth(slower, faster) == slower;
}

double ownDecay(const ModeBound& mode) noexcept {
    return mode.scale * mode.law.perSecond(mode.eigenvalue) / 2 + mode.extraPerSecond;
}

/// Returns the decay of the common bound as a share of the slower one's, at the objects' own
/// materials. 1 means that joining loses nothing.
double keptTogether(const ModeBound& a, const ModeBound& b) noexcept {
    constexpr double nothing = 1e-9; // [1/s]
    return (ownDecay(boundOfBoth(a, b)) + nothing) / (std::min(ownDecay(a), ownDecay(b)) + nothing);
}

/// Collects the slowest modes: the Pareto front of their figures.
class SlowestModes {
public:
    void add(const ModeBound& mode) {
        if (std::ranges::any_of(front, [&](const auto& other) { return bounds(other, mode); }))
            return;
        std::erase_if(front, [&](const auto& other) { return bounds(mode, other); });
        front.push_back(mode);
        if (front.size() > std::tuple_size_v<Modes>)
            joinClosest();
    }

    using Modes = decltype(DecayBounds::slowest);
    Modes modes() const {
        Modes result;
        std::ranges::copy(front, result.begin());
        return result;
    }

private:
    void joinClosest() {
        std::size_t first = 0, second = 1;
        double closest = 0;
        for (std::size_t b = 1; b < front.size(); ++b)
            for (std::size_t a = 0; a < b; ++a)
                if (const double kept = keptTogether(front[a], front[b]); kept > closest) {
                    closest = kept;
                    first = a;
                    second = b;
                }
        const auto joined = boundOfBoth(front[first], front[second]);
        std::erase_if(front, [&](const auto& other) { return bounds(joined, other); });
        front.push_back(joined);
    }

    std::vector<ModeBound> front;
};

/// Lowers the kept shares to those of a slot. A mode's λ over the pitch's λ is a ratio of two
/// linear functions of the thickness squared, so its minimum lies at an end of the range.
void addKept(DecayBounds& bounds, const SynthesiserSlot& slot) {
    if (!slot.pitch) {
        ++bounds.slotsWithoutPitch;
        return;
    }
    const auto& object = *slot.object;
    const auto& pitch = *slot.pitch;
    const double omega = 2 * std::numbers::pi * pitch.hz;
    const auto lowestShareAt = [&](double thicknessRatio) {
        const double bent = (thicknessRatio * thicknessRatio - 1) * pitch.bending;
        double lowest = infinity;
        for (std::size_t mode = 0; mode < object.modeCount(); ++mode)
            lowest = std::min(lowest,
                              object.eigenvalueAt(mode, thicknessRatio) / object.eigenvalues[mode]);
        return lowest * omega * omega * slot.sizeRatio * slot.sizeRatio / (pitch.eigenvalue + bent);
    };
    const double atReference = lowestShareAt(1);
    bounds.keptShare = std::min(bounds.keptShare, atReference);
    bounds.keptShareAtAnyThickness = std::min(bounds.keptShareAtAnyThickness, atReference);
    if (object.hasLiveThickness())
        for (const auto& range = parameterInfo(ParameterId::thickness);
             const double percent : {range.minimum, range.maximum})
            bounds.keptShareAtAnyThickness =
                std::min(bounds.keptShareAtAnyThickness, lowestShareAt(percent / 100));
}

/// Factors by which the settings multiply the figures of a bound.
struct Ratios {
    double eigenvalue, extra;
};

Ratios keptRatios(const DecayBounds& bounds, double thicknessRatio, double tuning) noexcept {
    return {.eigenvalue =
                (thicknessRatio == 1 ? bounds.keptShare : bounds.keptShareAtAnyThickness) * tuning *
                tuning,
            .extra = std::sqrt(bounds.keptShare) * tuning / std::max(thicknessRatio, 1.0)};
}

Ratios materialRatios(const ModeBound& mode,
                      const SynthesisSettings& settings,
                      double lowestFraction,
                      double tuning) noexcept {
    const auto& live = settings.material;
    const double material =
        live ? live->youngsModulusPa / live->densityKgPerM3 / mode.specificStiffness : 1;
    const double scaled = tuning / settings.sizeRatio;
    return {.eigenvalue = material * lowestFraction * scaled * scaled,
            .extra = std::sqrt(material) * scaled};
}

} // namespace

DecayBounds decayBounds(const Instrument& instrument, RingingKeys keys) {
    DecayBounds result;
    SlowestModes slowest;
    const auto slots = instrument.slots();
    std::vector<bool> isResized(slots.size(), false);
    for (int note = 0; note < 128; ++note)
        for (const Key& key : instrument.keysOf(note))
            if (key.slot >= 0 && !key.isOwn)
                isResized[static_cast<std::size_t>(key.slot)] = true;
    for (std::size_t index = 0; index < slots.size(); ++index) {
        const auto& slot = slots[index];
        const auto& object = *slot.object;
        if (object.modeCount() == 0 || (keys == RingingKeys::own && isResized[index]))
            continue;
        const auto& material = object.material;
        addKept(result, slot);
        result.most = each(result.most, material.damping, std::ranges::max);
        for (std::size_t mode = 0; mode < object.modeCount(); ++mode) {
            const double eigenvalue = object.eigenvalues[mode];
            const ModeDamping damping = object.damping(mode);
            slowest.add({.eigenvalue = eigenvalue / (slot.sizeRatio * slot.sizeRatio),
                         .scale = damping.scale,
                         .extraPerSecond = damping.extraPerSecond / slot.sizeRatio,
                         .specificStiffness = material.youngsModulusPa / material.densityKgPerM3,
                         .law = material.damping});
            result.maximumScale = std::max(result.maximumScale, damping.scale);
            result.maximumExtraShare =
                std::max(result.maximumExtraShare, damping.extraPerSecond / std::sqrt(eigenvalue));
            if (object.hasLiveThickness())
                result.maximumBending =
                    std::max(result.maximumBending, object.bending[mode] / eigenvalue);
        }
    }
    result.slowest = slowest.modes();
    return result;
}

double slowestDecay(const DecayBounds& bounds,
                    const SynthesisSettings& settings,
                    double semitonesBelow) noexcept {
    const auto& live = settings.material;
    const double tuning = settings.frequencyRatio * std::exp2(-semitonesBelow / 12);
    const double thin = std::min(settings.thicknessRatio, 1.0);
    const double lowestFraction = 1 + (thin * thin - 1) * bounds.maximumBending;
    double lowestEigenvalue = infinity, slowest = infinity;
    const auto include = [&](const ModeBound& mode, const Ratios& ratios) {
        constexpr double lowestOmega = 2 * std::numbers::pi * lowestSoundingHz;
        // A mode below the band does not sound, but other modes that it bounds may.
        const double eigenvalue =
            std::max(mode.eigenvalue * ratios.eigenvalue, lowestOmega * lowestOmega);
        if (!std::isfinite(eigenvalue))
            return;
        const auto& law = live ? live->damping : mode.law;
        lowestEigenvalue = std::min(lowestEigenvalue, eigenvalue);
        slowest = std::min(slowest, mode.scale * law.perSecond(eigenvalue) / 2 +
                                        mode.extraPerSecond * ratios.extra);
    };
    for (const auto& mode : bounds.slowest) {
        if (settings.keepPitch)
            include(mode, keptRatios(bounds, settings.thicknessRatio, tuning));
        if (!settings.keepPitch || bounds.slotsWithoutPitch > 0)
            include(mode, materialRatios(mode, settings, lowestFraction, tuning));
    }
    if (!std::isfinite(lowestEigenvalue))
        return infinity;
    // Modes that oscillate decay at d/2. The slower root of an over-damped mode is above λ/d, which
    // grows with λ.
    const double most =
        bounds.maximumScale * (live ? live->damping : bounds.most).perSecond(lowestEigenvalue) +
        2 * bounds.maximumExtraShare * std::sqrt(lowestEigenvalue / lowestFraction);
    return std::min(slowest / settings.decayRatio, lowestEigenvalue / most * settings.decayRatio);
}

double semitonesBelowEqual(const Instrument& instrument, const KeyTuning& tuning) {
    double below = 0;
    for (int note = 0; note < KeyTuning::notes; ++note)
        for (const Key& key : instrument.keysOf(note))
            if (const auto index = static_cast<std::size_t>(note);
                key.slot >= 0 && instrument.followsKey(static_cast<std::size_t>(key.slot)) &&
                !tuning.unmapped[index])
                below = std::max(below, -tuning.semitonesFromEqual[index]);
    return below;
}

} // namespace idiophone
