#include "Output/Tilt.h"

#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

/// The filter's state decays towards numbers that processors compute slowly. −160 dB of full scale.
constexpr float inaudible = 1e-8f;

} // namespace

void Tilt::prepare(double sampleRateHz, int maximumBlockSize, double rampSeconds) {
    gain.prepare(sampleRateHz, rampSeconds);
    const double warped = std::tan(std::numbers::pi * middleHz / sampleRateHz);
    coefficient = static_cast<float>(warped / (1 + warped));
    for (auto& channel : channels)
        channel.tilted.resize(static_cast<std::size_t>(maximumBlockSize));
    reset();
}

void Tilt::reset() noexcept {
    startsAtTarget = true;
    for (auto& channel : channels)
        channel.state = 0;
}

Room::Sound Tilt::process(const Room::Sound& sound, double brightness) noexcept {
    const double decibels = maximumDecibels * brightness / 100;
    gain.moveTo(static_cast<float>(std::pow(10, decibels / 20)));
    if (startsAtTarget)
        gain.jumpToTarget();
    startsAtTarget = false;
    auto& [left, right] = channels;
    for (std::size_t i = 0; i < sound.left.size(); ++i) {
        const float high = gain.next();
        const auto tilt = [&](Channel& channel, float sample) {
            const float step = coefficient * (sample - channel.state);
            const float low = channel.state + step;
            const float state = low + step;
            channel.state = std::abs(state) < inaudible ? 0 : state;
            // Written so that a gain of 1 returns the sample's own bits.
            channel.tilted[i] = sample + (1 / high - 1) * low + (high - 1) * (sample - low);
        };
        tilt(left, sound.left[i]);
        tilt(right, sound.right[i]);
    }
    return {std::span(left.tilted).first(sound.left.size()),
            std::span(right.tilted).first(sound.left.size())};
}

} // namespace idiophone
