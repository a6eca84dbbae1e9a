#include "Sampling/StrikeSampler.h"

#include "Output/OutputStage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

constexpr std::size_t blockSize = 512;
constexpr double fadeSeconds = 0.01;
constexpr double quietSeconds = 2; // longer than the beats of two close modes are low

float highest(std::span<const float> left, std::span<const float> right) {
    float peak = 0;
    for (const auto& channel : {left, right})
        for (const float sample : channel)
            peak = std::max(peak, std::abs(sample));
    return peak;
}

double gainOf(double decibels) {
    return std::pow(10, decibels / 20);
}

/// Begins the strike with the next block, and returns its events.
std::vector<MidiEvent> begin(const SampledStrike& strike, Player& player) {
    if (const auto* surface = std::get_if<SurfaceStrike>(&strike.by)) {
        player.strikeSurface(*surface);
        return {};
    }
    const auto& key = std::get<SampledStrike::KeyStrike>(strike.by);
    return {{.bytes = {0x90, static_cast<std::uint8_t>(key.key),
                       static_cast<std::uint8_t>(key.velocity)}}};
}

} // namespace

float StereoSamples::peak() const {
    return highest(left, right);
}

void StereoSamples::cutTail(double decibels, double sampleRateHz) {
    const double threshold = gainOf(decibels) * static_cast<double>(peak());
    std::size_t end = left.size();
    while (end > 0 && std::max(std::abs(left[end - 1]), std::abs(right[end - 1])) < threshold)
        --end;
    const auto fade = std::min(static_cast<std::size_t>(std::lround(fadeSeconds * sampleRateHz)),
                               left.size() - end);
    for (auto* channel : {&left, &right}) {
        channel->resize(end + fade);
        for (std::size_t i = 0; i < fade; ++i)
            (*channel)[end + i] *= static_cast<float>(
                0.5 + 0.5 * std::cos(std::numbers::pi * static_cast<double>(i + 1) /
                                     static_cast<double>(fade)));
    }
}

Result<StereoSamples> sampleStrike(const SampledInstrument& sampled,
                                   const SampledStrike& strike,
                                   double tailDecibels,
                                   double longestSeconds,
                                   const WorkControl& control) {
    auto values = sampled.values;
    values.set(ParameterId::limiter, 0);
    const double rate = sampled.sampleRateHz;
    Player player(sampled.instrument, rate, sampled.preset.surface,
                  sampled.preset.seed + strike.turn, sampled.preset.matched());
    player.setSilencedModes(silencedModes(*sampled.instrument, sampled.preset.mutedModes, {}));
    player.setTuning(sampled.tuning);
    player.setOffline(true);
    OutputStage output;
    output.prepare(rate, static_cast<int>(blockSize));

    auto events = begin(strike, player);
    StereoSamples samples;
    const auto end = static_cast<std::size_t>(std::llround(longestSeconds * rate));
    const auto patience = static_cast<std::size_t>(std::lround(quietSeconds * rate));
    float peak = 0;
    for (std::size_t done = 0, loudEnd = 0; done < end;) {
        if (control.isCancelled())
            return cancellation();
        const auto count = std::min(blockSize, end - done);
        samples.left.resize(done + count);
        samples.right.resize(done + count);
        const auto block = StereoSpan{samples.left, samples.right}.subspan(done, count);
        player.process(block, events, values);
        events.clear();
        const std::array channels{block.left.data(), block.right.data()};
        if (!output.process(block.left, block.right, channels, values))
            return failure("the sound is not finite");
        done += count;
        const float loudest = highest(block.left, block.right);
        peak = std::max(peak, loudest);
        if (loudest > gainOf(tailDecibels) * static_cast<double>(peak))
            loudEnd = done;
        if ((player.silent() && output.silent()) || done - loudEnd > patience)
            break;
    }
    return samples;
}

} // namespace idiophone
