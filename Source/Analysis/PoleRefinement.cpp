#include "Analysis/PoleRefinement.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <unsupported/Eigen/FFT>

namespace idiophone {
namespace {

using Complex = std::complex<double>;

constexpr double pi = std::numbers::pi;
constexpr std::size_t largestCluster = 6;
constexpr int iterations = 12;
constexpr double settledStep = 1e-7;                 // in ln α, and in widths
constexpr double lowestHz = 20, highestShare = 0.49; // of the sample rate
constexpr double slowestDecayPerSecond = 0.023, fastestDecayPerSecond = 3450;
// Maximum distance of a mode from its origin, as a factor of its decay and as a sum of widths and
// bins. The first line limits the search, the second a kept mode.
constexpr double farthestDecay = 4, farthestWidths = 3, farthestBins = 3;
constexpr double keptDecay = 2.5, keptWidths = 1, keptBins = 2;
constexpr double faintestAmplitude = 1e-4; // −80 dB
// Minimum energy that a mode explains, over the noise energy of one value: a constant and a term
// per recording.
constexpr double significantEnergy = 20, significantEnergyEach = 8;

double widthHz(const DecayPole& pole) {
    return pole.decayPerSecond / pi;
}

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

    /// Returns bins [first, second) of that band, extended by `moreHz` on each side.
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
            sinusoids.push_back(
                {.pole = pole, .amplitudes = std::vector<Complex>(spectra.size(), Complex(0))});
            origins.push_back(pole);
        }
    significances.assign(sinusoids.size(), 0);
    sortModes();
}

void PoleRefinement::sortModes() {
    std::vector<std::size_t> order(sinusoids.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return sinusoids[i].pole.frequencyHz; });
    const auto sorted = [&]<class Value>(const std::vector<Value>& values) {
        std::vector<Value> result;
        for (const std::size_t i : order)
            result.push_back(values[i]);
        return result;
    };
    sinusoids = sorted(sinusoids);
    origins = sorted(origins);
    significances = sorted(significances);
}

/// Returns the mode's pole after a step, limited to the allowed distance from its origin.
DecayPole
PoleRefinement::moved(std::size_t mode, const DecayPole& pole, double upHz, double faster) const {
    const auto& origin = origins[mode];
    const double reach = farthestWidths * widthHz(origin) + farthestBins * spectra.front().binHz();
    const double lowest = std::max(origin.frequencyHz - reach, lowestHz / 2);
    return {.frequencyHz = std::clamp(pole.frequencyHz + upHz, lowest,
                                      std::max(lowest, origin.frequencyHz + reach)),
            .decayPerSecond = std::clamp(pole.decayPerSecond * std::exp(faster),
                                         origin.decayPerSecond / farthestDecay,
                                         origin.decayPerSecond * farthestDecay)};
}

std::vector<PoleRefinement::Cluster> PoleRefinement::clusters() const {
    double binHz = 0;
    for (const auto& spectrum : spectra)
        binHz = std::max(binHz, spectrum.binHz());
    std::vector<Cluster> result;
    for (std::size_t mode = 0; mode < sinusoids.size(); ++mode) {
        const auto& pole = sinusoids[mode].pole;
        const double reach = std::max({4 * widthHz(pole), 6 * binHz, 4.0});
        bool joins = false;
        if (!result.empty() && result.back().modes.size() < largestCluster) {
            const auto& before = sinusoids[result.back().modes.back()].pole;
            joins =
                pole.frequencyHz - before.frequencyHz < widthHz(pole) + widthHz(before) + 3 * binHz;
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
            const auto& [pole, amplitudes] = sinusoids[mode];
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
    std::vector<DecayPole> poles;
    for (const std::size_t mode : cluster.modes)
        poles.push_back(sinusoids[mode].pole);
    const auto fit = settle(cluster, poles, pieces, background == Background::linear);
    for (std::size_t i = 0; i < cluster.modes.size(); ++i) {
        const std::size_t mode = cluster.modes[i];
        sinusoids[mode] = {.pole = poles[i], .amplitudes = fit.amplitudes[i]};
        significances[mode] = fit.significances[i];
    }
    changeResidual(cluster, -1);
}

/// Takes Levenberg-Marquardt steps from `poles`, which become the best found.
ClusterFit PoleRefinement::settle(const Cluster& cluster,
                                  std::vector<DecayPole>& poles,
                                  const std::vector<SpectrumPiece>& pieces,
                                  bool background) const {
    ClusterFit best = fitCluster(poles, pieces, background);
    double caution = 1e-3;
    for (int iteration = 0; iteration < iterations && caution < 1e6; ++iteration) {
        Eigen::MatrixXd curvature = best.curvature;
        curvature.diagonal() *= 1 + caution;
        const Eigen::VectorXd step = curvature.ldlt().solve(best.slope);
        if (!step.allFinite())
            break;
        auto tried = poles;
        double largest = 0;
        for (std::size_t i = 0; i < poles.size(); ++i) {
            const auto at = static_cast<Eigen::Index>(2 * i);
            // Limit a step to a few widths: the slope says nothing about poles farther away.
            const double reach = 2 * std::max(widthHz(poles[i]), spectra.front().binHz());
            const double up = std::clamp(step(at) / (2 * pi), -reach, reach);
            const double faster = std::clamp(step(at + 1), -1.2, 1.2);
            tried[i] = moved(cluster.modes[i], poles[i], up, faster);
            largest = std::max({largest, std::abs(faster), std::abs(up) / widthHz(poles[i])});
        }
        auto fit = fitCluster(tried, pieces, background);
        if (fit.cost < best.cost) {
            poles = std::move(tried);
            best = std::move(fit);
            caution = std::max(caution / 10, 1e-9);
            if (largest < settledStep)
                break;
        } else {
            if (largest < settledStep)
                break;
            caution *= 10;
        }
    }
    return best;
}

/// Adds a cluster's modes to the residual near their frequencies (`sign` 1) or subtracts them (−1).
void PoleRefinement::changeResidual(const Cluster& cluster, double sign) {
    const double more = std::max(500.0, 4 * (cluster.highHz - cluster.lowHz));
    for (std::size_t r = 0; r < spectra.size(); ++r) {
        auto& spectrum = spectra[r];
        const auto [first, last] = cluster.bins(spectrum, more);
        for (const std::size_t mode : cluster.modes) {
            const auto& [pole, amplitudes] = sinusoids[mode];
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
    for (const auto& [pole, amplitudes] : sinusoids) {
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

bool PoleRefinement::dropDoubtful() {
    std::vector<double> strongest(spectra.size());
    for (const auto& mode : sinusoids)
        for (std::size_t r = 0; r < spectra.size(); ++r)
            strongest[r] = std::max(strongest[r], std::abs(mode.amplitudes[r]));
    std::vector<DampedSinusoid> kept;
    std::vector<DecayPole> keptPoles;
    for (std::size_t i = 0; i < sinusoids.size(); ++i) {
        const auto& [pole, amplitudes] = sinusoids[i];
        bool heard = false;
        for (std::size_t r = 0; r < spectra.size(); ++r)
            heard = heard || std::abs(amplitudes[r]) > faintestAmplitude * strongest[r];
        const double least =
            significantEnergy + significantEnergyEach * static_cast<double>(spectra.size());
        const auto& origin = origins[i];
        const double ratio = pole.decayPerSecond / origin.decayPerSecond;
        const bool stayed = ratio < keptDecay && ratio > 1 / keptDecay &&
                            std::abs(pole.frequencyHz - origin.frequencyHz) <
                                keptWidths * widthHz(origin) + keptBins * spectra.front().binHz();
        if (heard && stayed && significances[i] > least) {
            kept.push_back(sinusoids[i]);
            keptPoles.push_back(pole);
        }
    }
    const bool dropped = kept.size() < sinusoids.size();
    sinusoids = std::move(kept);
    origins = std::move(keptPoles);
    significances.assign(sinusoids.size(), 0);
    if (dropped)
        recompute();
    return dropped;
}

} // namespace idiophone
