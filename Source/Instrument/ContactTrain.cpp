#include "Instrument/ContactTrain.h"

#include "Instrument/Scatter.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

constexpr double trainSeconds = 0.015; // FoleyAutomatic, impacts
// Chosen by ear: rubber does not chatter, and at most half of the impulse comes late.
constexpr double softContactSeconds = 0.001;
constexpr double largestLateShare = 0.5;

/// A part of a pulse: its share of the impulse; length and delay in contact times.
struct PulsePart {
    double share, length, delay;
};
constexpr std::array pulseParts{PulsePart{0.9048, 1.0, 0}, PulsePart{0.0917, 0.4256, 0.132},
                                PulsePart{0.0035, 0.1138, 0.5715}};

/// Random numbers of one strike, drawn in sequence.
class Draws {
public:
    /// The seed stays far from the numbers that scatter the strike positions.
    explicit Draws(std::uint32_t strikeNumber) : number(strikeNumber * 0x9e3779b1u + 0x5bd1e995u) {}

    double between(double lowest, double highest) {
        return lowest + (highest - lowest) * (scatter(number++) + 1) / 2;
    }

private:
    std::uint32_t number;
};

Strike scaled(const Strike& strike, double impulseShare, double durationSeconds) {
    Strike result = strike;
    for (float& component : result.impulseNewtonSeconds)
        component *= static_cast<float>(impulseShare);
    result.durationSeconds = durationSeconds;
    return result;
}

} // namespace

ContactTrain contactTrain(const Strike& strike,
                          double malletScale,
                          double chatterPercent,
                          std::uint32_t strikeNumber) {
    const double scale = std::min(malletScale, 1.0);
    const double softness = strike.durationSeconds / (scale * softContactSeconds);
    const double lateShare =
        largestLateShare * chatterPercent / 100 * std::clamp(1 - softness, 0.0, 1.0);
    ContactTrain train;
    if (!(lateShare > 0)) {
        train.add({.delaySeconds = 0, .strike = strike});
        return train;
    }

    Draws draws(strikeNumber);
    constexpr std::size_t maximumFurther = ContactTrain::maximumCollisions - 1;
    const auto further = std::min(maximumFurther, static_cast<std::size_t>(draws.between(2, 6)));
    std::array<double, maximumFurther> speeds{}; // relative to the strike's speed
    std::array<double, maximumFurther> times{};  // from 0 at the strike; scaled to seconds below
    double speed = 1, gap = 1, time = 0, speedSum = 0;
    for (std::size_t k = 0; k < further; ++k) {
        speedSum += speeds[k] = speed *= draws.between(0.4, 0.8);
        times[k] = time += gap;
        gap *= draws.between(0.5, 0.9);
    }

    const auto durationAt = [&](double relativeSpeed) { // T ∝ v^(−1/5)
        return strike.durationSeconds * std::pow(relativeSpeed, -0.2);
    };
    const double room = scale * trainSeconds - durationAt(speed);
    const double lastDelay = room * draws.between(0.4, 1);
    train.add({.delaySeconds = 0, .strike = scaled(strike, 1 - lateShare, strike.durationSeconds)});
    for (std::size_t k = 0; k < further; ++k)
        train.add(
            {.delaySeconds = lastDelay * times[k] / time,
             .strike = scaled(strike, lateShare * speeds[k] / speedSum, durationAt(speeds[k]))});
    return train;
}

ContactTrain withFilledNulls(const ContactTrain& train) {
    const auto& first = *train.begin();
    const double seconds = first.strike.durationSeconds;
    ContactTrain result;
    for (const auto& part : pulseParts)
        result.add({.delaySeconds = first.delaySeconds + part.delay * seconds,
                    .strike = scaled(first.strike, part.share, part.length * seconds)});
    for (const auto* further = train.begin() + 1; further != train.end(); ++further)
        result.add(*further);
    return result;
}

ContactTrain withModalPulses(const ContactTrain& train, std::span<const double> frequenciesHz) {
    if (frequenciesHz.empty())
        return train;
    const auto count = std::min(frequenciesHz.size(), ContactTrain::maximumModalPulses);
    const auto& first = *train.begin();
    ContactTrain result;
    for (const double frequencyHz : frequenciesHz.first(count))
        result.add(
            {.delaySeconds = first.delaySeconds,
             .strike = scaled(first.strike, 1 / static_cast<double>(count), 1 / frequencyHz)});
    for (const auto* further = train.begin() + 1; further != train.end(); ++further)
        result.add(*further);
    return result;
}

ContactTrain asPlayed(const ContactTrain& train, double sampleRateHz) {
    ContactTrain result;
    for (auto contact : train) {
        if (contact.strike.durationSeconds * sampleRateHz < shortestContactSamples)
            contact.strike.durationSeconds = 0;
        result.add(contact);
    }
    return result;
}

} // namespace idiophone
