#include "Analysis/SurfaceFit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace idiophone {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::size_t longestFit = std::size_t{1} << 19;
constexpr double steepestExponent = -4, shallowestExponent = 1;

/// Returns the largest even number up to `length` without prime factors above 5, for fast
/// transforms.
std::size_t transformLength(std::size_t length) {
    const auto isSmooth = [](std::size_t n) {
        for (const std::size_t prime : {2u, 3u, 5u})
            while (n % prime == 0)
                n /= prime;
        return n == 1;
    };
    length -= length % 2;
    while (!isSmooth(length))
        length -= 2;
    return length;
}

/// Returns the middle of the recording without its mean, faded in and out because a transform joins
/// its ends.
std::vector<double> middleOf(std::span<const float> samples) {
    const std::size_t length = transformLength(std::min(samples.size(), longestFit));
    const auto middle = samples.subspan((samples.size() - length) / 2, length);
    std::vector<double> result(middle.begin(), middle.end());
    Eigen::Map<Eigen::ArrayXd> values(result.data(), length);
    values -= values.mean();
    const std::size_t fade = length / 32;
    for (std::size_t i = 0; i < fade; ++i) {
        const double gain =
            0.5 - 0.5 * std::cos(pi * (static_cast<double>(i) + 0.5) / static_cast<double>(fade));
        result[i] *= gain;
        result[length - 1 - i] *= gain;
    }
    return result;
}

/// Returns the bin below which the spectrum is complete. A lower original sample rate or a lossy
/// codec may have cut off the bins above. Past the lowest bands, a power law falls by a few
/// decibels between 64ths of the band. The peak of a reson may fall faster, but is narrow: it is
/// not below the minimum of four bands.
std::size_t cutBin(const std::vector<std::complex<double>>& spectrum) {
    constexpr std::size_t bandCount = 64, compared = 4, lowestBand = 8;
    constexpr double steepFall = 0.1;
    const std::size_t bins = spectrum.size() - 1;
    std::array<double, bandCount> power{};
    for (std::size_t band = 0; band < bandCount; ++band) {
        const std::size_t begin = band * bins / bandCount, end = (band + 1) * bins / bandCount;
        for (std::size_t k = begin; k < end; ++k)
            power[band] += std::norm(spectrum[k]) / static_cast<double>(end - begin);
        const auto* before = power.data() + band;
        if (band >= lowestBand &&
            power[band] < steepFall * *std::min_element(before - compared, before))
            return (band - 1) * bins / bandCount; // the cut may lie in the band before
    }
    return bins;
}

/// An autoregressive model of order 2 that oscillates and decays, and its likelihood.
struct ResonFit {
    std::complex<double> pole; ///< in the upper half plane, inside the unit circle
    double cost = 0;           ///< minus twice the log-likelihood per sample, up to a constant
};

/// A recording's spectrum, whitened and fitted for one β after another.
class WhitenedScrape {
public:
    /// Fits the first `bins` of the `given` spectrum, which reaches to the Nyquist frequency.
    WhitenedScrape(std::vector<std::complex<double>> given, std::size_t lowest, std::size_t bins)
        : spectrum(std::move(given)), lowestBin(lowest),
          bandRatio(static_cast<double>(bins) / static_cast<double>(spectrum.size() - 1)) {
        spectrum.resize(bins + 1);
        transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
        logFrequencies.resize(bins + 1);
        for (std::size_t k = 1; k <= bins; ++k)
            logFrequencies[k] = std::log(static_cast<double>(k) / static_cast<double>(bins));
        for (const double value : logFrequencies)
            meanLogFrequency += value / static_cast<double>(bins);
    }

    /// Returns nothing if the best A has no resonance. The pole refers to a sample rate of twice
    /// the bins.
    std::optional<ResonFit> fit(double exponent) {
        std::vector<std::complex<double>> whitened(spectrum.size());
        for (std::size_t k = lowestBin; k < spectrum.size(); ++k)
            whitened[k] = spectrum[k] * std::exp(-exponent / 2 * logFrequencies[k]);
        auto found = covarianceFit(whitened);
        // In a part of the band, the model still refers to the recording's rate. Remove the
        // difference between both rates with the pole found before.
        constexpr int rounds = 3;
        double correction = 0;
        for (int round = 0; round < rounds && found && bandRatio < 1; ++round) {
            auto corrected = whitened;
            correction = bringToRecordingRate(corrected, found->pole);
            found = covarianceFit(corrected);
        }
        if (found)
            found->cost += exponent * meanLogFrequency - correction;
        return found;
    }

private:
    /// |A|² of a pole and its conjugate at an angle per sample.
    static double denominator(std::complex<double> pole, double angle) {
        const auto turn = std::polar(1.0, -angle);
        return std::norm((1.0 - pole * turn) * (1.0 - std::conj(pole) * turn));
    }

    /// Multiplies by |A| at the recording's rate over |A| at the fit's rate. Returns the mean of ln
    /// |A|² at the recording's rate, which would be 0 over the whole band.
    double bringToRecordingRate(std::vector<std::complex<double>>& values,
                                std::complex<double> pole) const {
        const auto poleOfRecording = std::exp(std::log(pole) * bandRatio);
        const double step = pi / static_cast<double>(values.size() - 1);
        double meanLog = 0;
        for (std::size_t k = 1; k < values.size(); ++k) {
            const double angle = step * static_cast<double>(k);
            const double wanted = denominator(poleOfRecording, angle * bandRatio);
            values[k] *= std::sqrt(wanted / denominator(pole, angle));
            meanLog += std::log(wanted) / static_cast<double>(values.size() - 1);
        }
        return meanLog;
    }

    std::optional<ResonFit> covarianceFit(const std::vector<std::complex<double>>& whitened) {
        transform.inv(samples, whitened, 2 * (whitened.size() - 1));
        const Eigen::Map<const Eigen::VectorXd> x(samples.data(), samples.size());
        // Leave out the faded ends, which the whitening spreads a little.
        const Eigen::Index first = x.size() / 16, count = x.size() - 2 * first;
        const auto product = [&](Eigen::Index i, Eigen::Index j) {
            return x.segment(first - i, count).dot(x.segment(first - j, count));
        };
        Eigen::Matrix2d normal;
        normal << product(1, 1), product(1, 2), product(2, 1), product(2, 2);
        const Eigen::Vector2d right(product(0, 1), product(0, 2));
        const Eigen::Vector2d a = normal.ldlt().solve(right);
        const double residual = (product(0, 0) - a.dot(right)) / static_cast<double>(count);
        const double realPart = a[0] / 2;
        const double imaginarySquared = -a[1] - realPart * realPart;
        if (!(imaginarySquared > 0 && -a[1] < 1 && residual > 0))
            return {};
        return ResonFit{{realPart, std::sqrt(imaginarySquared)}, std::log(residual)};
    }

    Eigen::FFT<double> transform;
    std::vector<std::complex<double>> spectrum;
    std::vector<double> samples;
    std::vector<double> logFrequencies; ///< relative to the highest; 0 at 0
    double meanLogFrequency = 0;
    std::size_t lowestBin;
    double bandRatio; ///< fitted band over the recording's band
};

struct BestFit {
    double exponent = 0;
    ResonFit reson;
};

/// Scans for the global minimum, then refines it with halved steps.
std::optional<BestFit> mostLikely(WhitenedScrape& scrape) {
    std::optional<BestFit> best;
    const auto tryExponent = [&](double exponent) {
        const auto found = scrape.fit(exponent);
        if (found && (!best || found->cost < best->reson.cost))
            best = BestFit{exponent, *found};
    };
    double step = 0.25;
    for (double exponent = steepestExponent; exponent <= shallowestExponent; exponent += step)
        tryExponent(exponent);
    while (best && step > 0.002) {
        step /= 2;
        const double centre = best->exponent;
        tryExponent(centre - step);
        tryExponent(centre + step);
    }
    return best;
}

} // namespace

Result<SurfaceFit> fitSurface(std::span<const float> samples, double sampleRateHz) {
    if (static_cast<double>(samples.size()) < shortestScrapeSeconds * sampleRateHz ||
        samples.size() < 1024)
        return failure("it is shorter than a quarter of a second");
    if (!std::ranges::all_of(samples, [](float value) { return std::isfinite(value); }))
        return failure("it holds samples that are not numbers");
    const auto recording = middleOf(samples);
    constexpr double silentRms = 1e-5;
    double power = 0;
    for (const double value : recording)
        power += value * value / static_cast<double>(recording.size());
    if (!(power > silentRms * silentRms))
        return failure("it is silent");

    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    std::vector<std::complex<double>> spectrum;
    transform.fwd(spectrum, recording);
    const std::size_t bins = transformLength(2 * cutBin(spectrum)) / 2;
    const double binHz = sampleRateHz / static_cast<double>(recording.size());
    // Leave out handling noise and rumble.
    constexpr double lowestHz = 20;
    const auto lowestBin = static_cast<std::size_t>(std::ceil(lowestHz / binHz));
    WhitenedScrape scrape(std::move(spectrum), lowestBin, bins);
    const auto best = mostLikely(scrape);
    if (!best)
        return failure("its spectrum shows no resonance of a surface");
    const double fittedRateHz = 2 * static_cast<double>(bins) * binHz;
    const auto& pole = best->reson.pole;
    return SurfaceFit{.spectrumExponent = best->exponent,
                      .resonFrequencyHz = std::arg(pole) * fittedRateHz / (2 * pi),
                      .resonDampingPerSecond = -std::log(std::abs(pole)) * fittedRateHz,
                      .highestFrequencyHz = fittedRateHz / 2};
}

} // namespace idiophone
