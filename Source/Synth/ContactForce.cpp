// SPDX-License-Identifier: Apache-2.0
#include "Synth/ContactForce.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {
namespace {

constexpr auto period = static_cast<double>(SurfaceProfile::periodSamples);

/// NaN becomes `lowest`.
double bounded(double value, double lowest, double highest) noexcept {
    return value >= lowest ? std::min(value, highest) : lowest;
}

/// Returns a seed's place on the profile. Multiplicative hashing spreads neighbouring seeds.
double placeOnProfile(std::uint64_t seed) noexcept {
    const std::uint64_t hash = (seed + 1) * 0x9e3779b97f4a7c15u;
    return static_cast<double>(hash >> 11) * 0x1p-53 * period;
}

} // namespace

ContactForce::ContactForce(std::shared_ptr<const SurfaceProfile> shared, std::uint64_t seed)
    : profile(std::move(shared)), firstPosition(placeOnProfile(seed)), position(firstPosition) {
    setSettings({});
}

void ContactForce::setSettings(const ContactForceSettings& wanted) noexcept {
    settings = {.kind = wanted.kind,
                .rollLowPassHz = bounded(wanted.rollLowPassHz, 1, 20000),
                .rollDryMix = bounded(wanted.rollDryMix, 0, 1),
                .rollModalCoupling = bounded(wanted.rollModalCoupling, 0, 10)};
    lowPassPole = ResonPole::lowPass(settings.rollLowPassHz, profile->sampleRateHz());
    lowPassGain = lowPassPole.unitGainAtZero();
}

void ContactForce::setCoupledModes(std::span<const CoupledMode> modes) noexcept {
    const double rateHz = profile->sampleRateHz();
    std::size_t count = 0;
    for (const auto& [frequencyHz, dampingPerSecond] : modes) {
        if (count == maxCoupledModes)
            break;
        const bool sounds = frequencyHz > 0 && frequencyHz < ResonPole::highestFrequency * rateHz &&
                            dampingPerSecond > 0 && dampingPerSecond <= rateHz;
        if (!sounds)
            continue;
        auto& filter = modeFilters[count++];
        // A mode that hardly decays would take very long to reach its level.
        filter.pole = ResonPole::at(frequencyHz, std::max(dampingPerSecond, 0.1), rateHz);
        // With this gain, Re z of a sine at the pole's angle becomes that sine.
        filter.gain = 2 * (1 - std::hypot(filter.pole.real, filter.pole.imaginary));
    }
    for (std::size_t i = count; i < modeCount; ++i)
        modeFilters[i].state = {};
    modeCount = count;
}

ContactForce::Levels ContactForce::levelsFor(const ContactMotion& motion) const noexcept {
    const auto& surface = profile->surface();
    const double speed = bounded(std::abs(motion.speedMetresPerSecond), 0, 1e6);
    const double normalForce = bounded(motion.normalForceNewtons, 0, 1e9);
    const double speedRatio = speed / surface.referenceSpeedMetresPerSecond;
    const bool sticks = speed < surface.slowestSpeedMetresPerSecond;
    Levels result;
    result.step = std::min(speedRatio, 1.0);
    if (!sticks)
        result.force =
            surface.roughness * profile->gain(speedRatio) * std::sqrt(speedRatio * normalForce);
    result.pole = profile->resonPole(speedRatio);
    result.inputGain = result.pole.unitGainAtZero();
    if (settings.kind == ContactKind::roll) {
        result.dry = settings.rollDryMix;
        result.filtered = 1 - settings.rollDryMix;
        result.coupled = modeCount > 0 ? settings.rollModalCoupling : 0;
    }
    return result;
}

double ContactForce::coupledModes(double input) noexcept {
    double sum = 0;
    for (std::size_t i = 0; i < modeCount; ++i) {
        auto& filter = modeFilters[i];
        filter.state.step(filter.pole, filter.gain * input);
        sum += filter.state.real;
    }
    return sum;
}

bool ContactForce::render(const ContactMotion& motion,
                          std::span<float, cellSamples> forceNewtons) noexcept {
    const Levels before = std::exchange(levels, levelsFor(motion));
    if (before.force == 0 && levels.force == 0) {
        clearFilters();
        std::ranges::fill(forceNewtons, 0.0f);
        return false;
    }
    // After silence, start at the new levels: there is no sound whose pitch or mix could glide.
    const Levels& from = before.force == 0 ? levels : before;
    const bool lowPassed = from.filtered > 0 || levels.filtered > 0;
    const bool coupled = from.coupled > 0 || levels.coupled > 0;
    for (std::size_t i = 0; i < forceNewtons.size(); ++i) {
        const double fraction = static_cast<double>(i + 1) / cellSamples;
        const auto between = [fraction](double a, double b) { return a + fraction * (b - a); };
        const ResonPole pole{between(from.pole.real, levels.pole.real),
                             between(from.pole.imaginary, levels.pole.imaginary)};
        reson.step(pole, between(from.inputGain, levels.inputGain) * profile->at(position));
        const double scrape = reson.imaginary;
        double sound = between(from.dry, levels.dry) * scrape;
        if (lowPassed) {
            lowPass.step(lowPassPole, lowPassGain * scrape);
            sound += between(from.filtered, levels.filtered) * lowPass.imaginary;
        }
        if (coupled)
            sound += between(from.coupled, levels.coupled) * coupledModes(scrape);
        forceNewtons[i] = static_cast<float>(between(before.force, levels.force) * sound);
        position += between(before.step, levels.step);
        if (position >= period)
            position -= period;
    }
    // Clear the filters that had no input, so that their old state is not heard later.
    if (!lowPassed)
        lowPass = {};
    if (!coupled)
        clearModes();
    return true;
}

void ContactForce::clearModes() noexcept {
    for (auto& filter : modeFilters)
        filter.state = {};
}

void ContactForce::clearFilters() noexcept {
    reson = {};
    lowPass = {};
    clearModes();
}

void ContactForce::reset() noexcept {
    position = firstPosition;
    levels = {};
    clearFilters();
}

} // namespace idiophone
