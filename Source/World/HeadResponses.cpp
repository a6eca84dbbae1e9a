// SPDX-License-Identifier: Apache-2.0
#include "World/HeadResponses.h"

#include "World/HeadModel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

using std::numbers::pi;

constexpr int azimuths = 360 / HeadResponses::stepDegrees;
constexpr double leadSeconds = 0.0003; // kept before the earliest onset
constexpr float onsetShare = 0.1f;     // of the highest sample
constexpr double fadeSeconds = 0.001;
constexpr double loudest = 1000; // maximum sample, beyond any real head

/// Returns the earliest onset of all responses, in samples.
std::size_t firstOnset(const HeadMeasurement& measured) {
    const auto length = measured.lengthSamples;
    std::size_t first = length;
    for (std::size_t start = 0; start < measured.responses.size(); start += length) {
        const auto response = std::span(measured.responses).subspan(start, length);
        float highest = 0;
        for (const float sample : response)
            highest = std::max(highest, std::abs(sample));
        const auto onset = std::ranges::find_if(
            response, [&](float x) { return highest > 0 && std::abs(x) >= onsetShare * highest; });
        first = std::min(first, static_cast<std::size_t>(onset - response.begin()));
    }
    return first;
}

double energy(std::span<const float> response) {
    double sum = 0;
    for (const float sample : response)
        sum += static_cast<double>(sample) * static_cast<double>(sample);
    return sum;
}

/// Returns the loudness of the spherical head for noise from straight ahead, in the band of a
/// sample rate.
double sphereLoudness(double rateHz) {
    const Listener listener{.positionMetres = {0, 0, 0}, .towardsMetres = {0, 1, 0}};
    const auto path = HeadModel(listener).path({0, 1, 0});
    return headShadow(path.ears[0].highFrequencyGain, rateHz).energy();
}

} // namespace

Eigen::Vector3d HeadResponses::direction(std::size_t index) {
    const auto step = [](std::size_t steps) {
        return static_cast<double>(steps) * stepDegrees * pi / 180;
    };
    const double up = step(index / azimuths) - pi / 2, left = step(index % azimuths);
    return {std::cos(up) * std::cos(left), std::cos(up) * std::sin(left), std::sin(up)};
}

std::size_t HeadResponses::nearest(const Eigen::Vector3d& towards) const noexcept {
    const double across = std::hypot(towards.x(), towards.y());
    const double up = std::atan2(towards.z(), across) * 180 / pi;
    const double left = std::atan2(towards.y(), towards.x()) * 180 / pi;
    if (!std::isfinite(up + left))
        return 0;
    const auto elevation = std::lround((up + 90) / stepDegrees);
    const auto azimuth = std::lround((left + 360) / stepDegrees) % azimuths;
    return static_cast<std::size_t>(elevation * azimuths + azimuth);
}

Result<std::shared_ptr<const HeadResponses>> HeadResponses::make(const HeadMeasurement& measured) {
    const double rate = measured.sampleRateHz;
    const auto whole = measured.lengthSamples;
    if (!(rate > 0) || !(measured.measuredRateHz > 0) || whole == 0 ||
        measured.responses.size() % (directionCount * 2) != 0 ||
        measured.responses.size() / (directionCount * 2) != whole)
        return failure("it does not have responses of both ears from all around");
    if (!std::ranges::all_of(measured.responses, [](float x) { return std::isfinite(x); }))
        return failure("one of its responses is not a finite number");

    const auto onset = firstOnset(measured);
    const auto start = onset - std::min(static_cast<std::size_t>(leadSeconds * rate), onset);
    const std::shared_ptr<HeadResponses> head(new HeadResponses);
    head->length =
        std::min(static_cast<std::size_t>(std::ceil(longestSeconds * rate)), whole - start);
    const auto fade = std::min(static_cast<std::size_t>(fadeSeconds * rate), head->length);
    for (std::size_t from = 0; from < measured.responses.size(); from += whole) {
        const auto kept = std::span(measured.responses).subspan(from + start, head->length);
        head->samples.insert(head->samples.end(), kept.begin(), kept.end());
        for (std::size_t i = 0; i < fade; ++i)
            head->samples[head->samples.size() - 1 - i] *=
                static_cast<float>(i) / static_cast<float>(fade);
    }
    const auto ahead = head->nearest(Eigen::Vector3d::UnitX());
    const double loudness =
        (energy(head->response(ahead, 0)) + energy(head->response(ahead, 1))) / 2;
    // Another sample rate has the same band but a different number of samples.
    const double bandRate = std::min(measured.measuredRateHz, rate);
    const double gain = std::sqrt(sphereLoudness(bandRate) * bandRate / (loudness * rate));
    if (!std::isfinite(gain))
        return failure("nothing is heard from straight ahead");
    for (float& sample : head->samples) {
        const double scaled = gain * static_cast<double>(sample);
        if (!(std::abs(scaled) <= loudest))
            return failure("it is far louder from elsewhere than from straight ahead");
        sample = static_cast<float>(scaled);
    }
    return head;
}

Result<std::shared_ptr<const HeadResponses>> HeadResponses::of(std::vector<float> samples) {
    if (samples.empty() || samples.size() % (directionCount * 2) != 0)
        return failure("it does not have responses of both ears from all around");
    if (!std::ranges::all_of(samples, [](float x) { return std::abs(x) <= loudest; }))
        return failure("one of its responses is not a number in range");
    const std::shared_ptr<HeadResponses> head(new HeadResponses);
    head->length = samples.size() / (directionCount * 2);
    head->samples = std::move(samples);
    return head;
}

} // namespace idiophone
