// Computes the power spectrum of a long sound under a Hann window, for tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <vector>

namespace idiophone::test {

/// Averages segments of 2^15 samples that overlap by half (Welch): bins of 1.5 Hz at 48 kHz.
class Periodogram {
public:
    Periodogram(std::span<const float> samples, double sampleRateHz)
        : binHz(sampleRateHz / segment), bins(segment / 2) {
        std::vector<std::complex<double>> values(segment);
        double count = 0;
        for (std::size_t begin = 0; begin + segment <= samples.size(); begin += segment / 2) {
            for (std::size_t i = 0; i < segment; ++i)
                values[i] = samples[begin + i] *
                            (1 - std::cos(2 * std::numbers::pi * static_cast<double>(i) / segment));
            transform(values);
            ++count;
            for (std::size_t k = 0; k < bins.size(); ++k)
                bins[k] += std::norm(values[k]);
        }
        for (double& bin : bins)
            bin /= count;
    }

    /// Returns the power from `lowHz` to `highHz`, in an arbitrary unit.
    double power(double lowHz, double highHz) const {
        double sum = 0;
        for (std::size_t k = 0; k < bins.size(); ++k)
            if (frequencyHz(k) >= lowHz && frequencyHz(k) < highHz)
                sum += bins[k];
        return sum;
    }

    /// Returns the centre of the 2 % band between the two with the largest power per width.
    double peakHz(double lowHz, double highHz) const {
        double best = lowHz, most = 0;
        for (double centre = lowHz; centre < highHz; centre *= 1.002) {
            const double density = power(centre * 0.99, centre * 1.01) / centre;
            if (density > most) {
                most = density;
                best = centre;
            }
        }
        return best;
    }

    double centroidHz() const {
        double weighted = 0, sum = 0;
        for (std::size_t k = 1; k < bins.size(); ++k) {
            weighted += frequencyHz(k) * bins[k];
            sum += bins[k];
        }
        return weighted / sum;
    }

private:
    static constexpr std::size_t segment = std::size_t{1} << 15;

    double frequencyHz(std::size_t bin) const { return static_cast<double>(bin) * binHz; }

    static void transform(std::vector<std::complex<double>>& values) {
        for (std::size_t i = 1, reversed = 0; i < values.size(); ++i) {
            std::size_t bit = values.size() >> 1;
            for (; (reversed & bit) != 0; bit >>= 1)
                reversed ^= bit;
            reversed ^= bit;
            if (i < reversed)
                std::swap(values[i], values[reversed]);
        }
        for (std::size_t half = 1; half < values.size(); half *= 2)
            for (std::size_t i = 0; i < half; ++i) {
                const auto root = std::polar(1.0, -std::numbers::pi * static_cast<double>(i) /
                                                      static_cast<double>(half));
                for (std::size_t start = i; start < values.size(); start += 2 * half) {
                    const auto turned = values[start + half] * root;
                    values[start + half] = values[start] - turned;
                    values[start] += turned;
                }
            }
    }

    double binHz;
    std::vector<double> bins;
};

} // namespace idiophone::test
