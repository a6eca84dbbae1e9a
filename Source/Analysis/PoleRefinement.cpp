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
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double pi = std::numbers::pi;
constexpr std::size_t largestCluster = 6;
constexpr int iterations = 12;
constexpr double lowestHz = 20, highestShare = 0.49; // of the sample rate
constexpr double slowestDecayPerSecond = 0.023, fastestDecayPerSecond = 3450;
// How far a mode may go from where it was found, in factors of its decay and in widths and bins,
// and how far one may have gone that is kept.
constexpr double farthestDecay = 4, farthestWidths = 3, farthestBins = 3;
constexpr double keptDecay = 2.5, keptWidths = 1, keptBins = 2;
constexpr double faintestAmplitude = 1e-4; // −80 dB
// Energy a mode must take out, in those of one value of noise, for itself and for each recording.
constexpr double significantEnergy = 20, significantEnergyEach = 8;

/// P(z) = Σ z^n w^{−n} over n < N at a bin w = e^{2πik/N}, and dP/dz.
struct CutExponential {
    CutExponential(const Complex& pole, double rateHz, std::size_t length)
        : z(std::exp(pole / rateHz)), last(std::exp(pole / rateHz * static_cast<double>(length))),
          size(static_cast<double>(length)) {}

    Complex value(const Complex& conjugateBin) const {
        return (1.0 - last) / (1.0 - z * conjugateBin);
    }
    /// With respect to the pole, times the sample rate: z dP/dz.
    Complex slope(const Complex& conjugateBin) const {
        const Complex turned = z * conjugateBin, rest = 1.0 - turned;
        return ((1.0 - last) * turned / rest - size * last) / rest;
    }

    Complex z, last;
    double size;
};

double widthHz(const DecayPole& pole) {
    return pole.decayPerSecond / pi;
}

/// The transform of Re(a z^n) where `up` is of z and `down` of its conjugate.
Complex transformed(const Complex& amplitude, const Complex& up, const Complex& down) {
    return 0.5 * (amplitude * up + std::conj(amplitude) * down);
}

/// As it is, but with only small prime factors and at most a 64th shorter.
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

/// Of complex values that are mostly noise, the variance of one part.
double noiseOf(std::vector<double> powers) {
    const auto middle = powers.begin() + static_cast<std::ptrdiff_t>(powers.size() / 2);
    std::nth_element(powers.begin(), middle, powers.end());
    return *middle / std::numbers::ln2 / 2;
}

} // namespace

struct PoleRefinement::Cluster {
    std::vector<std::size_t> modes;
    double lowHz = 0, highHz = 0; ///< the band that is fitted

    /// Bins [first, second) of that band, or of one so much wider to either side.
    std::pair<std::size_t, std::size_t> bins(const Spectrum& spectrum, double moreHz = 0) const {
        const double bin = spectrum.binHz();
        const auto last = static_cast<double>(spectrum.residual.size() - 1);
        return {static_cast<std::size_t>(std::clamp(std::ceil((lowHz - moreHz) / bin), 1.0, last)),
                static_cast<std::size_t>(std::clamp(std::floor((highHz + moreHz) / bin), 1.0, last)) +
                    1};
    }
};

struct PoleRefinement::Trial {
    double cost = 0;
    MatrixXd curvature; ///< of the cost over (ω, ln α) of each mode
    VectorXd slope;
    std::vector<std::vector<Complex>> amplitudes; ///< [modes][recordings]
    std::vector<double> significances;            ///< [modes]
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

/// A pole of that mode after a step, as far as it may go.
DecayPole PoleRefinement::moved(std::size_t mode,
                                const DecayPole& pole,
                                double upHz,
                                double faster) const {
    const auto& origin = origins[mode];
    const double reach =
        farthestWidths * widthHz(origin) + farthestBins * spectra.front().binHz();
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
            joins = pole.frequencyHz - before.frequencyHz <
                    widthHz(pole) + widthHz(before) + 3 * binHz;
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

void PoleRefinement::refine(int sweeps, Background background) {
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        // Loud ones first: what they leave of their neighbours' bands is what those are fitted to.
        auto groups = clusters();
        const auto loudness = [&](const Cluster& cluster) {
            double most = 0;
            for (std::size_t i = 0; i < spectra.size(); ++i) {
                const auto [first, last] = cluster.bins(spectra[i]);
                for (const std::size_t mode : cluster.modes)
                    most = std::max(most, std::abs(sinusoids[mode].amplitudes[i]));
                for (std::size_t k = first; k < last && sweep == 0; ++k)
                    most = std::max(most, std::abs(spectra[i].residual[k]));
            }
            return most;
        };
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

void PoleRefinement::refine(const Cluster& cluster, Background background) {
    changeResidual(cluster, 1);
    std::vector<std::vector<Complex>> targets;
    for (const auto& spectrum : spectra) {
        const auto [first, last] = cluster.bins(spectrum);
        targets.emplace_back(spectrum.residual.begin() + static_cast<std::ptrdiff_t>(first),
                             spectrum.residual.begin() + static_cast<std::ptrdiff_t>(last));
    }
    std::vector<DecayPole> poles;
    for (const std::size_t mode : cluster.modes)
        poles.push_back(sinusoids[mode].pole);
    Trial best = fit(cluster, poles, targets, background);
    double caution = 1e-3;
    for (int iteration = 0; iteration < iterations && caution < 1e6; ++iteration) {
        MatrixXd curvature = best.curvature;
        curvature.diagonal() *= 1 + caution;
        const VectorXd step = curvature.ldlt().solve(best.slope);
        auto tried = poles;
        double largest = 0;
        for (std::size_t i = 0; i < poles.size(); ++i) {
            // A few widths at a time: farther off the slope says nothing.
            const double reach = 2 * std::max(widthHz(poles[i]), spectra.front().binHz());
            const auto at = static_cast<Index>(2 * i);
            const double up = std::clamp(step(at) / (2 * pi), -reach, reach);
            const double faster = std::clamp(step(at + 1), -1.2, 1.2);
            tried[i] = moved(cluster.modes[i], poles[i], up, faster);
            largest = std::max({largest, std::abs(faster),
                                std::abs(up) / std::max(widthHz(poles[i]), 1e-6)});
        }
        if (!std::isfinite(largest))
            break;
        Trial trial = fit(cluster, tried, targets, background);
        if (trial.cost < best.cost) {
            const bool settled = largest < 1e-6;
            poles = std::move(tried);
            best = std::move(trial);
            caution = std::max(caution / 10, 1e-9);
            if (settled)
                break;
        } else if (largest < 1e-9) {
            break;
        } else {
            caution *= 10;
        }
    }
    for (std::size_t i = 0; i < cluster.modes.size(); ++i) {
        const std::size_t mode = cluster.modes[i];
        sinusoids[mode] = {.pole = poles[i], .amplitudes = best.amplitudes[i]};
        significances[mode] = best.significances[i];
    }
    changeResidual(cluster, -1);
}

PoleRefinement::Trial
PoleRefinement::fit(const Cluster& cluster,
                    const std::vector<DecayPole>& poles,
                    const std::vector<std::vector<Complex>>& targets,
                    Background background) const {
    const auto count = static_cast<Index>(poles.size());
    const Index extra = background == Background::linear ? 4 : 0;
    Trial trial{.cost = 0,
                .curvature = MatrixXd::Zero(2 * count, 2 * count),
                .slope = VectorXd::Zero(2 * count),
                .amplitudes = std::vector(poles.size(), std::vector<Complex>(spectra.size())),
                .significances = std::vector<double>(poles.size(), 0)};
    for (std::size_t r = 0; r < spectra.size(); ++r) {
        const auto& spectrum = spectra[r];
        const auto rows = static_cast<Index>(targets[r].size());
        if (2 * rows <= 2 * count + extra)
            continue;
        MatrixXd basis = MatrixXd::Zero(2 * rows, 2 * count + extra);
        VectorXd target(2 * rows);
        std::vector<CutExponential> ups, downs;
        for (const auto& pole : poles) {
            ups.emplace_back(pole.perSecond(), spectrum.rateHz, spectrum.length);
            downs.emplace_back(std::conj(pole.perSecond()), spectrum.rateHz, spectrum.length);
        }
        const std::size_t first = cluster.bins(spectrum).first;
        Eigen::VectorXcd conjugateBins(rows);
        for (Index k = 0; k < rows; ++k) {
            conjugateBins(k) = std::polar(1.0, -2 * pi * static_cast<double>(first + k) /
                                                   static_cast<double>(spectrum.length));
            target(2 * k) = targets[r][static_cast<std::size_t>(k)].real();
            target(2 * k + 1) = targets[r][static_cast<std::size_t>(k)].imag();
            for (Index i = 0; i < count; ++i) {
                const auto at = static_cast<std::size_t>(i);
                const Complex up = ups[at].value(conjugateBins(k));
                const Complex down = downs[at].value(conjugateBins(k));
                const Complex cosine = transformed({1, 0}, up, down);
                const Complex sine = transformed({0, 1}, up, down);
                basis(2 * k, 2 * i) = cosine.real();
                basis(2 * k + 1, 2 * i) = cosine.imag();
                basis(2 * k, 2 * i + 1) = sine.real();
                basis(2 * k + 1, 2 * i + 1) = sine.imag();
            }
            if (extra > 0) {
                const double place = 2.0 * static_cast<double>(k) / static_cast<double>(rows) - 1;
                basis(2 * k, 2 * count) = basis(2 * k + 1, 2 * count + 1) = 1;
                basis(2 * k, 2 * count + 2) = basis(2 * k + 1, 2 * count + 3) = place;
            }
        }
        // Columns differ by the ratio of decays.
        const VectorXd scale = basis.colwise().norm().cwiseMax(1e-300).cwiseInverse().transpose();
        basis *= scale.asDiagonal();
        const Eigen::HouseholderQR<MatrixXd> solver(basis);
        const Index columns = basis.cols();
        VectorXd solved = solver.householderQ().adjoint() * target;
        const auto triangle = solver.matrixQR().topRows(columns).triangularView<Eigen::Upper>();
        const VectorXd scaled = triangle.solve(solved.head(columns));
        VectorXd residual = target - basis * scaled;
        const VectorXd amplitudes = scaled.cwiseProduct(scale);
        trial.cost += residual.squaredNorm();

        MatrixXd slopes(2 * rows, 2 * count);
        for (Index i = 0; i < count; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const Complex amplitude(amplitudes(2 * i), amplitudes(2 * i + 1));
            trial.amplitudes[at][r] = amplitude;
            for (Index k = 0; k < rows; ++k) {
                const Complex up = ups[at].slope(conjugateBins(k)) / spectrum.rateHz;
                const Complex down = downs[at].slope(conjugateBins(k)) / spectrum.rateHz;
                // The pole is −α + iω, and that below −α − iω.
                const Complex byFrequency = transformed(amplitude, up * Complex(0, 1),
                                                        down * Complex(0, -1));
                const Complex byDecay =
                    -poles[at].decayPerSecond * transformed(amplitude, up, down);
                slopes(2 * k, 2 * i) = byFrequency.real();
                slopes(2 * k + 1, 2 * i) = byFrequency.imag();
                slopes(2 * k, 2 * i + 1) = byDecay.real();
                slopes(2 * k + 1, 2 * i + 1) = byDecay.imag();
            }
        }
        trial.slope += slopes.transpose() * residual;
        const MatrixXd inSpace = (solver.householderQ().adjoint() * slopes).topRows(columns);
        trial.curvature += slopes.transpose() * slopes - inSpace.transpose() * inSpace;

        std::vector<double> powers(static_cast<std::size_t>(rows));
        for (Index k = 0; k < rows; ++k)
            powers[static_cast<std::size_t>(k)] = residual.segment<2>(2 * k).squaredNorm();
        const double noise = std::max(noiseOf(std::move(powers)), 1e-300);
        const MatrixXd inverse = triangle.solve(MatrixXd::Identity(columns, columns));
        const MatrixXd covariance = inverse * inverse.transpose();
        for (Index i = 0; i < count; ++i) {
            const Eigen::Vector2d own = scaled.segment<2>(2 * i);
            trial.significances[static_cast<std::size_t>(i)] +=
                own.dot(covariance.block<2, 2>(2 * i, 2 * i).inverse() * own) / noise;
        }
    }
    // Where nothing depends on a pole, as on that of a mode without amplitude, it stays.
    trial.curvature.diagonal().array() += 1e-300;
    return trial;
}

/// Adds a cluster's modes (`sign` 1) to the residual about their frequencies, or takes them out.
void PoleRefinement::changeResidual(const Cluster& cluster, double sign) {
    const double more = std::max(500.0, 4 * (cluster.highHz - cluster.lowHz));
    for (std::size_t r = 0; r < spectra.size(); ++r) {
        auto& spectrum = spectra[r];
        const auto [first, last] = cluster.bins(spectrum, more);
        for (const std::size_t mode : cluster.modes) {
            const auto& [pole, amplitudes] = sinusoids[mode];
            if (amplitudes[r] == Complex(0))
                continue;
            const CutExponential up(pole.perSecond(), spectrum.rateHz, spectrum.length);
            const CutExponential down(std::conj(pole.perSecond()), spectrum.rateHz,
                                      spectrum.length);
            for (std::size_t k = first; k < last; ++k) {
                const Complex bin = std::polar(1.0, -2 * pi * static_cast<double>(k) /
                                                        static_cast<double>(spectrum.length));
                spectrum.residual[k] +=
                    sign * transformed(amplitudes[r], up.value(bin), down.value(bin));
            }
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
        result.push_back(
            {.samples = residualOf(spectra[r], r), .sampleRateHz = spectra[r].rateHz});
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
                                keptWidths * widthHz(origin) +
                                    keptBins * spectra.front().binHz();
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
