#include "Output/PendingPeaks.h"

#include "Output/HighestMagnitude.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace idiophone {
namespace {

constexpr double halfTaps = PendingPeaks::taps / 2.0;
constexpr double kaiserBeta = 5;

/// The modified Bessel function of order 0, by its series. For magnitudes up to `kaiserBeta`.
double besselI0(double x) {
    double sum = 1, term = 1;
    for (int k = 1; term > 1e-17 * sum; ++k) {
        term *= x * x / (4.0 * k * k);
        sum += term;
    }
    return sum;
}

/// The interpolation kernel at a distance in samples.
double kernel(double distance) {
    const double place = distance / halfTaps;
    if (std::abs(place) >= 1)
        return 0;
    const double angle = std::numbers::pi * distance;
    return (distance == 0 ? 1 : std::sin(angle) / angle) *
           besselI0(kaiserBeta * std::sqrt(1 - place * place)) / besselI0(kaiserBeta);
}

/// Returns the time of a pending value, in samples after the next sample.
double timeOf(std::size_t value) {
    return static_cast<double>(value) / PendingPeaks::phases - halfTaps;
}

/// The autocorrelation that the prediction assumes. Its spectrum is flat up to a quarter of the
/// sample rate and falls by 12 dB an octave above. A floor at -20 dB stabilises the prediction.
/// Both were chosen by experiment. With less treble, bright chords below the threshold count as
/// peaks. With more, sudden peaks near a quarter of the rate are missed.
double autocorrelation(std::size_t lag) {
    constexpr int steps = 500;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double frequency = 0.5 * (i + 0.5) / steps;
        sum += std::cos(2 * std::numbers::pi * frequency * static_cast<double>(lag)) *
               (1 / (1 + std::pow(frequency / 0.25, 4)) + 0.01);
    }
    return sum / steps;
}

} // namespace

struct PendingPeaks::Tables {
    std::array<float, count> ofNext{}; ///< weights of the next sample in the values
    std::array<std::array<float, count>, taps / 2> ofFuture{}; ///< weights of later samples
    std::array<float, count> shareToCome{};                    ///< see Bounds
    /// The weights of `next` and the remembered samples, newest first, for each predicted sample.
    std::array<std::array<float, remembered>, taps / 2> prediction{};
    double highestSum = 0; ///< sum of the kernel's magnitudes, maximum of all phases

    Tables() {
        for (std::size_t value = 0; value < count; ++value)
            ofNext[value] = static_cast<float>(kernel(timeOf(value)));
        for (std::size_t value = 0; value < count; ++value)
            for (std::size_t ahead = 1; ahead <= taps; ++ahead)
                shareToCome[value] += static_cast<float>(
                    std::abs(kernel(timeOf(value) - static_cast<double>(ahead))));
        for (std::size_t phase = 0; phase < phases; ++phase) {
            double sum = 0;
            for (std::size_t value = phase; value < count; value += phases)
                sum += std::abs(kernel(timeOf(value)));
            highestSum = std::max(highestSum, sum);
        }
        for (std::size_t ahead = 0; ahead < ofFuture.size(); ++ahead) {
            for (std::size_t value = 0; value < count; ++value)
                ofFuture[ahead][value] =
                    static_cast<float>(kernel(timeOf(value) - static_cast<double>(ahead + 1)));
            prediction[ahead] = predictionWeights(ahead + 1);
        }
    }

    /// Solves the normal equations of one predicted sample.
    static std::array<float, remembered> predictionWeights(std::size_t ahead) {
        Eigen::Matrix<double, remembered, remembered> correlations;
        Eigen::Matrix<double, remembered, 1> right;
        for (std::size_t row = 0; row < remembered; ++row) {
            for (std::size_t column = 0; column < remembered; ++column)
                correlations(row, column) =
                    autocorrelation(row > column ? row - column : column - row);
            right(row) = autocorrelation(row + ahead);
        }
        const auto weights = correlations.ldlt().solve(right).eval();
        std::array<float, remembered> result{};
        for (std::size_t past = 0; past < remembered; ++past)
            result[past] = static_cast<float>(weights(past));
        return result;
    }
};

const PendingPeaks::Tables& PendingPeaks::sharedTables() {
    static const Tables shared;
    return shared;
}

PendingPeaks::PendingPeaks() : tables(sharedTables()) {}

float PendingPeaks::levelAlwaysBelow(float ceiling) {
    return static_cast<float>(ceiling / sharedTables().highestSum);
}

void PendingPeaks::reset() noexcept {
    values.fill(0);
    samples.fill(0);
}

void PendingPeaks::push(float sample) noexcept {
    for (std::size_t i = 0; i + phases < count; ++i)
        values[i] = values[i + phases] + tables.ofNext[i + phases] * sample;
    std::fill(values.end() - phases, values.end(), 0.0f);
    std::copy_backward(samples.begin(), samples.end() - 1, samples.end());
    samples[0] = sample;
}

float PendingPeaks::highestBeforeSilence(float next) const noexcept {
    std::array<float, count> after;
    for (std::size_t i = 0; i < count; ++i)
        after[i] = values[i] + tables.ofNext[i] * next;
    return highestMagnitude(after);
}

float PendingPeaks::highestBefore(float next, const Future& future) const noexcept {
    std::array<float, count> after;
    for (std::size_t i = 0; i < count; ++i)
        after[i] = values[i] + tables.ofNext[i] * next;
    for (std::size_t ahead = 0; ahead < future.size(); ++ahead)
        for (std::size_t i = 0; i < count; ++i)
            after[i] += tables.ofFuture[ahead][i] * future[ahead];
    return highestMagnitude(after);
}

float PendingPeaks::highestIfPredicted(float next) const noexcept {
    return std::min(highestBefore(next, noisePrediction(next)),
                    highestBefore(next, sinePrediction(next)));
}

PendingPeaks::Future PendingPeaks::noisePrediction(float next) const noexcept {
    Future future;
    for (std::size_t ahead = 0; ahead < future.size(); ++ahead) {
        const auto& weights = tables.prediction[ahead];
        future[ahead] = weights[0] * next;
        for (std::size_t past = 1; past < remembered; ++past)
            future[ahead] += weights[past] * samples[past - 1];
    }
    return future;
}

/// A sine satisfies x[n+1] = c x[n] - x[n-1] with |c| <= 2. Finds c by least squares.
PendingPeaks::Future PendingPeaks::sinePrediction(float next) const noexcept {
    float product = samples[0] * (next + samples[1]), power = samples[0] * samples[0];
    for (std::size_t past = 1; past + 1 < remembered; ++past) {
        product += samples[past] * (samples[past - 1] + samples[past + 1]);
        power += samples[past] * samples[past];
    }
    const float factor = power > 0 ? std::clamp(product / power, -2.0f, 2.0f) : 0;
    Future future;
    float before = samples[0], last = next;
    for (float& sample : future) {
        sample = std::clamp(factor * last - before, -1.0f, 1.0f);
        before = std::exchange(last, sample);
    }
    return future;
}

bool PendingPeaks::isWithin(const Bounds& bounds, float next) const noexcept {
    std::array<float, count> reached;
    for (std::size_t i = 0; i < count; ++i)
        reached[i] =
            std::abs(values[i] + tables.ofNext[i] * next) + bounds.reserve * tables.shareToCome[i];
    return highestMagnitude(reached) <= bounds.ceiling;
}

float PendingPeaks::maximumGainWithin(const Bounds& bounds,
                                      float next,
                                      float maximumGain) const noexcept {
    float gain = maximumGain;
    for (std::size_t i = 0; i < count; ++i) {
        const float added = tables.ofNext[i] * next;
        const float magnitude = std::abs(added);
        const float room = bounds.ceiling - bounds.reserve * tables.shareToCome[i] -
                           (added < 0 ? -values[i] : values[i]);
        if (gain * magnitude > room)
            gain = std::max(room / magnitude, 0.0f);
    }
    return gain;
}

} // namespace idiophone
