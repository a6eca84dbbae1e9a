#include "Analysis/PoleRefinement.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace idiophone {
namespace {

using Complex = std::complex<double>;

constexpr double pi = std::numbers::pi;
constexpr std::size_t largestCluster = 6;
constexpr double lowestHz = 20, highestShare = 0.49; // of the sample rate
constexpr double slowestDecayPerSecond = 0.023, fastestDecayPerSecond = 3450;
// Maximum distance of a kept mode from its origin, as a factor of its decay and as a sum of widths
// and bins. The search goes farther (ClusterFit).
constexpr double keptDecay = 2.5, keptWidths = 1, keptBins = 2;
constexpr double faintestAmplitude = 1e-4; // −80 dB
// Minimum energy that a mode explains, over the noise energy of one value: a constant and a term
// per recording.
constexpr double significantEnergy = 20, significantEnergyEach = 8;

/// Returns a length with only small prime factors, at most a 64th shorter.
std::size_t quickLength(std::size_t length) {
    std::size_t factor = 1;
    while (length / factor >= 128)
        factor *= 2;
    return length / factor * factor;
}

std::vector<Complex> transform(const std::vector<double>& samples) {
    Eigen::FFT<double> fft;
    std::vector<Complex> bins;
    fft.fwd(bins, samples);
    bins.resize(samples.size() / 2 + 1);
    return bins;
}

} // namespace

struct PoleRefinement::Cluster {
    std::vector<std::size_t> modes;
    double lowHz = 0, highHz = 0; ///< the fitted band

    /// Returns bins [first, second) of the fitted band, extended by `moreHz` on each side.
    std::pair<std::size_t, std::size_t> bins(const Spectrum& spectrum, double moreHz = 0) const {
        const double bin = spectrum.binHz();
        const auto last = static_cast<double>(spectrum.residual.size() - 1);
        return {
            static_cast<std::size_t>(std::clamp(std::ceil((lowHz - moreHz) / bin), 1.0, last)),
            static_cast<std::size_t>(std::clamp(std::floor((highHz + moreHz) / bin), 1.0, last)) +
                1};
    }
};

PoleRefinement::PoleRefinement(std::span<const DecayRecording> recordings) {
    for (const auto& recording : recordings) {
        auto& spectrum = spectra.emplace_back();
        spectrum.length = quickLength(recording.samples.size());
        spectrum.rateHz = recording.sampleRateHz;
        spectrum.samples.assign(recording.samples.begin(),
                                recording.samples.begin() +
                                    static_cast<std::ptrdiff_t>(spectrum.length));
        spectrum.residual = transform(spectrum.samples);
    }
    highestHz = std::numeric_limits<double>::infinity();
    for (const auto& spectrum : spectra)
        highestHz = std::min(highestHz, highestShare * spectrum.rateHz);
}

void PoleRefinement::add(std::span<const DecayPole> poles) {
    for (const auto& pole : poles)
        if (pole.frequencyHz >= lowestHz && pole.frequencyHz <= highestHz &&
            pole.decayPerSecond >= slowestDecayPerSecond &&
            pole.decayPerSecond <= std::min(fastestDecayPerSecond, pole.frequencyHz)) {
            found.push_back(
                {.sinusoid = {.pole = pole, .amplitudes = std::vector<Complex>(spectra.size())},
                 .origin = pole});
        }
    sortModes();
}

void PoleRefinement::sortModes() {
    std::ranges::sort(found, {}, [](const Mode& mode) { return mode.sinusoid.pole.frequencyHz; });
}

std::vector<DampedSinusoid> PoleRefinement::modes() const {
    std::vector<DampedSinusoid> result;
    std::ranges::transform(found, std::back_inserter(result), &Mode::sinusoid);
    return result;
}

std::vector<PoleRefinement::Cluster> PoleRefinement::clusters() const {
    double binHz = 0;
    for (const auto& spectrum : spectra)
        binHz = std::max(binHz, spectrum.binHz());
    std::vector<Cluster> result;
    for (std::size_t mode = 0; mode < found.size(); ++mode) {
        const auto& pole = found[mode].sinusoid.pole;
        const double reach = std::max({4 * pole.widthHz(), 6 * binHz, 4.0});
        bool joins = false;
        if (!result.empty() && result.back().modes.size() < largestCluster) {
            const auto& before = found[result.back().modes.back()].sinusoid.pole;
            joins = pole.frequencyHz - before.frequencyHz <
                    pole.widthHz() + before.widthHz() + 3 * binHz;
        }
        if (!joins)
            result.push_back({.modes = {}, .lowHz = pole.frequencyHz, .highHz = pole.frequencyHz});
        auto& cluster = result.back();
        cluster.modes.push_back(mode);
        cluster.lowHz = std::min(cluster.lowHz, pole.frequencyHz - reach);
        cluster.highHz = std::max(cluster.highHz, pole.frequencyHz + reach);
    }
    return result;
}

// Loud clusters come first, because their residual falls into their neighbours' bands.
void PoleRefinement::refine(int sweeps, Background background) {
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        const auto groups = clusters();
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t i = 0; i < groups.size(); ++i)
            order.emplace_back(-loudness(groups[i]), i);
        std::ranges::sort(order);
        for (const auto& [level, group] : order)
            refine(groups[group], background);
        sortModes();
        recompute();
    }
}

/// Returns the highest bin of the cluster in the residual or in its own modes.
double PoleRefinement::loudness(const Cluster& cluster) const {
    double most = 0;
    for (std::size_t r = 0; r < spectra.size(); ++r) {
        const auto& spectrum = spectra[r];
        const auto [first, last] = cluster.bins(spectrum);
        for (std::size_t k = first; k < last; ++k)
            most = std::max(most, std::abs(spectrum.residual[k]));
        for (const std::size_t mode : cluster.modes) {
            const auto& [pole, amplitudes] = found[mode].sinusoid;
            const CutSinusoid sinusoid(pole, spectrum.rateHz, spectrum.length);
            const auto peak = static_cast<std::size_t>(pole.frequencyHz / spectrum.binHz());
            most = std::max(
                most, std::abs(sinusoid.at(amplitudes[r], conjugateBin(peak, spectrum.length))));
        }
    }
    return most;
}

void PoleRefinement::refine(const Cluster& cluster, Background background) {
    changeResidual(cluster, 1);
    std::vector<SpectrumPiece> pieces;
    for (const auto& spectrum : spectra) {
        const auto [first, last] = cluster.bins(spectrum);
        const auto begin = spectrum.residual.begin();
        pieces.push_back({.length = spectrum.length,
                          .rateHz = spectrum.rateHz,
                          .firstBin = first,
                          .bins = {begin + static_cast<std::ptrdiff_t>(first),
                                   begin + static_cast<std::ptrdiff_t>(last)}});
    }
    std::vector<DecayPole> poles, origins;
    for (const std::size_t mode : cluster.modes) {
        poles.push_back(found[mode].sinusoid.pole);
        origins.push_back(found[mode].origin);
    }
    const auto fit = refineCluster(poles, origins, pieces, background == Background::linear);
    for (std::size_t i = 0; i < cluster.modes.size(); ++i) {
        Mode& mode = found[cluster.modes[i]];
        mode.sinusoid = {.pole = poles[i], .amplitudes = fit.amplitudes[i]};
        mode.significance = fit.significances[i];
    }
    changeResidual(cluster, -1);
}

/// Adds a cluster's modes to the residual near their frequencies (`sign` 1) or subtracts them (−1).
void PoleRefinement::changeResidual(const Cluster& cluster, double sign) {
    const double more = std::max(500.0, 4 * (cluster.highHz - cluster.lowHz));
    for (std::size_t r = 0; r < spectra.size(); ++r) {
        auto& spectrum = spectra[r];
        const auto [first, last] = cluster.bins(spectrum, more);
        for (const std::size_t mode : cluster.modes) {
            const auto& [pole, amplitudes] = found[mode].sinusoid;
            if (amplitudes[r] == Complex(0))
                continue;
            const CutSinusoid sinusoid(pole, spectrum.rateHz, spectrum.length);
            for (std::size_t k = first; k < last; ++k)
                spectrum.residual[k] +=
                    sign * sinusoid.at(amplitudes[r], conjugateBin(k, spectrum.length));
        }
    }
}

std::vector<double> PoleRefinement::residualOf(const Spectrum& spectrum,
                                               std::size_t recording) const {
    auto rest = spectrum.samples;
    for (const Mode& mode : found) {
        const auto& [pole, amplitudes] = mode.sinusoid;
        const Complex z = std::exp(pole.perSecond() / spectrum.rateHz);
        Complex value = amplitudes[recording];
        const double faintest = 1e-12 * std::abs(value);
        for (std::size_t n = 0; n < rest.size() && std::norm(value) > faintest * faintest; ++n) {
            rest[n] -= value.real();
            value *= z;
        }
    }
    return rest;
}

void PoleRefinement::recompute() {
    for (std::size_t r = 0; r < spectra.size(); ++r)
        spectra[r].residual = transform(residualOf(spectra[r], r));
}

std::vector<DecayRecording> PoleRefinement::residuals() const {
    std::vector<DecayRecording> result;
    for (std::size_t r = 0; r < spectra.size(); ++r)
        result.push_back({.samples = residualOf(spectra[r], r), .sampleRateHz = spectra[r].rateHz});
    return result;
}

bool PoleRefinement::isDoubtful(const Mode& mode, const std::vector<double>& strongest) const {
    const auto& [pole, amplitudes] = mode.sinusoid;
    bool isAudible = false;
    for (std::size_t r = 0; r < spectra.size(); ++r)
        isAudible = isAudible || std::abs(amplitudes[r]) > faintestAmplitude * strongest[r];
    const double ratio = pole.decayPerSecond / mode.origin.decayPerSecond;
    const bool hasStayed =
        ratio < keptDecay && ratio > 1 / keptDecay &&
        std::abs(pole.frequencyHz - mode.origin.frequencyHz) <
            keptWidths * mode.origin.widthHz() + keptBins * spectra.front().binHz();
    const double neededEnergy =
        significantEnergy + significantEnergyEach * static_cast<double>(spectra.size());
    return !(isAudible && hasStayed && mode.significance > neededEnergy);
}

bool PoleRefinement::dropDoubtful() {
    std::vector<double> strongest(spectra.size());
    for (const Mode& mode : found)
        for (std::size_t r = 0; r < spectra.size(); ++r)
            strongest[r] = std::max(strongest[r], std::abs(mode.sinusoid.amplitudes[r]));
    const bool hasDropped =
        std::erase_if(found, [&](const Mode& mode) { return isDoubtful(mode, strongest); }) > 0;
    for (Mode& mode : found) {
        mode.origin = mode.sinusoid.pole;
        mode.significance = 0;
    }
    if (hasDropped)
        recompute();
    return hasDropped;
}

} // namespace idiophone
