#include "Output/DelayNetwork.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

// A random search over 140 sets found none that has a denser echo, a more even spectrum and fewer
// repetitions at the same time.
constexpr std::array<double, DelayNetwork::lineCount> lineSeconds{
    0.02,    0.02173, 0.02339, 0.02551, 0.02747, 0.02969, 0.03181, 0.03423,
    0.03659, 0.03931, 0.04217, 0.04519, 0.04871, 0.05233, 0.05669, 0.0617};
static_assert(lineSeconds.front() == DelayNetwork::shortestSeconds);
static_assert(lineSeconds.back() == DelayNetwork::longestSeconds);
constexpr std::array<std::array<double, 4>, 2> diffuserSeconds{
    {{0.00307, 0.00471, 0.00697, 0.01033}, {0.00331, 0.00439, 0.00733, 0.00977}}};
constexpr float diffusion = 0.6f;
// Each row of a Hadamard matrix of order 16 is a pattern of signs. The two inputs and outputs use
// different rows, so that their responses differ.
constexpr std::size_t leftRow = 5, rightRow = 10;
// At a decay time of 1 s, the response to noise is as strong as the noise (measured).
constexpr float inputGain = 0.35f;

constexpr float signOf(std::size_t row, std::size_t line) {
    return std::popcount(row & line) % 2 == 0 ? 1.0f : -1.0f;
}

std::size_t samplesOf(double seconds, double rateHz) {
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(seconds * rateHz)));
}

double decaySecondsAt8kHz(double seconds) {
    return 1 / (1 / (0.6 * seconds) + 1 / 1.7);
}

/// Returns the pole p at which (1 − p)/(1 − p/z) has the magnitude `ratio` at an angular frequency.
double poleFor(double ratio, double angle) {
    const double squared = ratio * ratio;
    const double half = 1 - squared * std::cos(angle), end = 1 - squared;
    return end < 1e-9 ? 0 : (half - std::sqrt(half * half - end * end)) / end;
}

} // namespace

void DelayNetwork::prepare(double sampleRateHz, double glideSeconds) {
    rateHz = sampleRateHz;
    glideSamples = samplesOf(glideSeconds, rateHz);
    for (std::size_t line = 0; line < lineCount; ++line)
        lines[line].samples.resize(samplesOf(lineSeconds[line], rateHz));
    for (std::size_t channel = 0; channel < 2; ++channel)
        for (std::size_t i = 0; i < diffuserCount; ++i)
            diffusers[channel][i].samples.resize(samplesOf(diffuserSeconds[channel][i], rateHz));
    decaySeconds = 0;
    clear();
}

void DelayNetwork::clear() noexcept {
    const auto empty = [](Delay& delay) {
        std::ranges::fill(delay.samples, 0.0f);
        delay.position = 0;
    };
    std::ranges::for_each(lines, empty);
    for (auto& channel : diffusers)
        std::ranges::for_each(channel, empty);
    for (auto& absorber : absorbers)
        absorber.state = 0;
    finishGlide();
    isClear = true;
}

void DelayNetwork::finishGlide() noexcept {
    glideLeft = 0;
    for (auto& absorber : absorbers) {
        absorber.gain = absorber.gainTarget;
        absorber.pole = absorber.poleTarget;
        absorber.gainStep = absorber.poleStep = 0;
    }
}

void DelayNetwork::setDecay(double seconds) noexcept {
    if (seconds == decaySeconds)
        return;
    decaySeconds = seconds;
    glideLeft = glideSamples;
    const double referenceHz = std::min(8000.0, 0.45 * rateHz);
    const double angle = 2 * std::numbers::pi * referenceHz / rateHz;
    const double difference = 1 / decaySecondsAt8kHz(seconds) - 1 / seconds;
    for (std::size_t line = 0; line < lineCount; ++line) {
        const double length = static_cast<double>(lines[line].samples.size()) / rateHz;
        auto& absorber = absorbers[line];
        absorber.gainTarget = static_cast<float>(std::pow(10, -3 * length / seconds));
        absorber.poleTarget =
            static_cast<float>(poleFor(std::pow(10, -3 * length * difference), angle));
        const auto steps = static_cast<float>(glideSamples);
        absorber.gainStep = (absorber.gainTarget - absorber.gain) / steps;
        absorber.poleStep = (absorber.poleTarget - absorber.pole) / steps;
    }
    if (isClear)
        finishGlide();
}

void DelayNetwork::process(std::span<float> left, std::span<float> right) noexcept {
    isClear = false;
    const auto maximumCount = std::min(maximumPiece, lines.front().samples.size());
    for (std::size_t done = 0, count = 0; done < left.size(); done += count) {
        count = std::min(maximumCount, left.size() - done);
        if (glideLeft > 0)
            count = std::min(count, glideLeft);
        processPiece(left.subspan(done, count), right.subspan(done, count));
        if (glideLeft > 0 && (glideLeft -= count) == 0)
            finishGlide();
    }
}

void DelayNetwork::diffuse(std::array<Delay, diffuserCount>& diffusers,
                           std::span<float> samples) noexcept {
    for (auto& delay : diffusers)
        for (float& sample : samples) {
            float& stored = delay.samples[delay.position];
            const float output = stored - diffusion * sample;
            stored = sample + diffusion * output;
            sample = output;
            if (++delay.position == delay.samples.size())
                delay.position = 0;
        }
}

/// Processes a piece no longer than the shortest line, so that all outputs are known before any
/// input.
void DelayNetwork::processPiece(std::span<float> left, std::span<float> right) noexcept {
    const auto count = left.size();
    diffuse(diffusers[0], left);
    diffuse(diffusers[1], right);
    for (std::size_t line = 0; line < lineCount; ++line)
        readLine(line, count);
    Block inputLeft{}, inputRight{}, outputLeft{}, outputRight{};
    for (std::size_t i = 0; i < count; ++i) {
        inputLeft[i] = inputGain * left[i];
        inputRight[i] = inputGain * right[i];
    }
    for (std::size_t line = 0; line < lineCount; ++line) {
        const float toLeft = signOf(leftRow, line), toRight = signOf(rightRow, line);
        for (std::size_t i = 0; i < count; ++i) {
            outputLeft[i] += toLeft * blocks[line][i];
            outputRight[i] += toRight * blocks[line][i];
        }
    }
    // The fast Walsh-Hadamard transform. The scale of 1/4 makes it orthogonal.
    for (std::size_t half = 1; half < lineCount; half *= 2)
        for (std::size_t line = 0; line < lineCount; ++line)
            if ((line & half) == 0)
                for (std::size_t i = 0; i < count; ++i) {
                    const float sum = blocks[line][i] + blocks[line + half][i];
                    blocks[line + half][i] = blocks[line][i] - blocks[line + half][i];
                    blocks[line][i] = sum;
                }
    for (std::size_t line = 0; line < lineCount; ++line) {
        const auto& input = line % 2 == 0 ? inputLeft : inputRight;
        for (std::size_t i = 0; i < count; ++i)
            blocks[line][i] = 0.25f * blocks[line][i] + input[i];
        writeLine(line, std::span(blocks[line]).first(count));
    }
    std::copy_n(outputLeft.begin(), count, left.begin());
    std::copy_n(outputRight.begin(), count, right.begin());
}

void DelayNetwork::readLine(std::size_t line, std::size_t sampleCount) noexcept {
    const auto& delay = lines[line];
    auto& absorber = absorbers[line];
    std::size_t position = delay.position;
    for (std::size_t i = 0; i < sampleCount; ++i) {
        absorber.gain += absorber.gainStep;
        absorber.pole += absorber.poleStep;
        const float sample = delay.samples[position];
        absorber.state = sample + absorber.pole * (absorber.state - sample);
        blocks[line][i] = absorber.gain * absorber.state;
        if (++position == delay.samples.size())
            position = 0;
    }
}

void DelayNetwork::writeLine(std::size_t line, std::span<const float> input) noexcept {
    auto& delay = lines[line];
    for (const float sample : input) {
        delay.samples[delay.position] = sample;
        if (++delay.position == delay.samples.size())
            delay.position = 0;
    }
}

} // namespace idiophone
