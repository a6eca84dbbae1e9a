#include "Analysis/MaterialFit.h"

#include "Analysis/DampingFit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <ranges>
#include <vector>

namespace idiophone {
namespace {

constexpr double lowestRatio = 0.04, highestRatio = 4;
// Usual deviation of a mode that is found, in ln f: errors of shape, elements and Poisson's ratio.
constexpr double deviation = 0.012;
constexpr double matchedWithin = 2.5 * deviation;
constexpr double falseShare = 0.1; ///< of the measured modes, those that are not of the object
/// A weaker mode, relative to the strongest, counts nothing.
constexpr double faintestDecibels = -60;
/// A missing low mode lowers the score by this: the strike may have missed it.
constexpr double missing = 0.4;
constexpr std::size_t lowModes = 8;
/// The first suits glass and ceramics, the second steel, the third brass and plastics.
constexpr std::array poissonRatios{0.2, 0.27, 0.34};
/// Scores, in nats. Several hundred ratios are tried: one of them reaches some 6 by chance.
constexpr double convincing = 5, nearlyAsGood = 3;

double logOf(const MeasuredMode& mode) {
    return std::log(mode.frequencyHz);
}

/// 1 for the strongest mode, 0 for the faintest.
std::vector<double> weightsOf(std::span<const MeasuredMode> modes) {
    std::vector<double> decibels;
    for (const auto& mode : modes)
        decibels.push_back(20 * std::log10(std::ranges::max(mode.amplitudes)));
    const double strongest = std::ranges::max(decibels);
    for (double& each : decibels)
        each = std::max(1 - (each - strongest) / faintestDecibels, 0.0);
    return decibels;
}

/// The density of the object's modes over ln f, relative to its mean thereabouts: high at a mode
/// that stands alone, 1 where modes are too close to tell apart.
class ModeDensity {
public:
    explicit ModeDensity(std::span<const double> frequenciesHz) {
        for (const double hz : frequenciesHz)
            logs.push_back(std::log(hz));
        for (double x = logs.front() - margin; x < logs.back() + smooth; x += step)
            table.push_back(densityAt(x, deviation) / densityAt(x, smooth));
    }

    /// Nothing above the band.
    std::optional<double> at(double logHz) const {
        const double place = std::round((logHz - logs.front() + margin) / step);
        if (place < 0)
            return 0;
        return place < static_cast<double>(table.size())
                   ? std::optional(table[static_cast<std::size_t>(place)])
                   : std::nullopt;
    }
    double nearestTo(double logHz) const {
        const auto above = std::ranges::lower_bound(logs, logHz);
        if (above == logs.end() || (above != logs.begin() && logHz - above[-1] < *above - logHz))
            return above[-1];
        return *above;
    }
    std::span<const double> lowest() const {
        return std::span(logs).first(std::min(lowModes, logs.size()));
    }

private:
    static constexpr double smooth = 0.3, margin = 1, step = deviation / 8;

    double densityAt(double x, double width) const {
        double sum = 0;
        const auto begin = std::ranges::lower_bound(logs, x - 6 * width);
        for (auto log = begin; log != logs.end() && *log < x + 6 * width; ++log)
            sum += std::exp(-std::pow((x - *log) / width, 2) / 2);
        return (sum + 1e-9) / width;
    }

    std::vector<double> logs, table;
};

/// The logarithm of how much better the object explains the modes at this shift in ln f than
/// chance.
double scoreAt(double shift,
               std::span<const MeasuredMode> modes,
               std::span<const double> weights,
               const ModeDensity& object) {
    double score = 0, lowest = std::numeric_limits<double>::max(), highest = -lowest;
    for (std::size_t i = 0; i < modes.size(); ++i) {
        const double place = logOf(modes[i]) - shift;
        if (weights[i] > 0) {
            lowest = std::min(lowest, place);
            highest = std::max(highest, place);
        }
        if (const auto density = object.at(place)) {
            const double own = (1 - falseShare) * weights[i]; // probability
            score += std::log(std::lerp(1.0, *density, own));
        }
    }
    for (const double low : object.lowest())
        if (low > lowest && low < highest &&
            std::ranges::none_of(modes, [&](const MeasuredMode& mode) {
                return std::abs(logOf(mode) - shift - low) < matchedWithin;
            }))
            score -= missing;
    return score;
}

/// Moves the shift to the weighted mean of what is matched. Returns the matched modes.
std::vector<std::size_t> settle(double& shift,
                                std::span<const MeasuredMode> modes,
                                std::span<const double> weights,
                                const ModeDensity& object) {
    std::vector<std::size_t> matched;
    for (int round = 0; round < 4; ++round) {
        matched.clear();
        double sum = 0, weight = 0;
        for (std::size_t i = 0; i < modes.size(); ++i) {
            const double place = logOf(modes[i]) - shift;
            const double distance = place - object.nearestTo(place);
            if (std::abs(distance) > matchedWithin)
                continue;
            matched.push_back(i);
            // A match that chance explains as well says nothing.
            const double trust =
                weights[i] * std::max(std::log(object.at(place).value_or(0) + 1e-9), 0.0);
            sum += trust * distance;
            weight += trust;
        }
        if (weight > 0)
            shift += sum / weight;
    }
    return matched;
}

std::vector<DecayOfMode> decaysOf(std::span<const MeasuredMode> modes) {
    std::vector<DecayOfMode> decays;
    const auto weights = weightsOf(modes);
    for (std::size_t i = 0; i < modes.size(); ++i)
        if (weights[i] > 0)
            decays.push_back({modes[i].eigenvalue(), modes[i].decayPerSecond, weights[i]});
    return decays;
}

/// How far a library material is from a fitted one, in units of usual deviations.
double distanceTo(const Material& known,
                  const DampingLaw& damping,
                  std::optional<double> stiffnessOverDensity,
                  std::span<const MeasuredMode> modes) {
    constexpr double usualDamping = 0.7, usualSpeed = 0.1; // in ln α and ln c
    double decays = 0;
    for (const auto& mode : modes) {
        const double eigenvalue = mode.eigenvalue();
        decays += std::log(damping.perSecond(eigenvalue) / known.damping.perSecond(eigenvalue));
    }
    double distance = std::abs(decays / static_cast<double>(modes.size())) / usualDamping;
    if (stiffnessOverDensity)
        distance += std::abs(std::log(*stiffnessOverDensity * known.densityKgPerM3 /
                                      known.youngsModulusPa)) /
                    2 / usualSpeed;
    return distance;
}

MaterialFit fitWith(std::span<const MeasuredMode> modes,
                    std::optional<double> stiffnessOverDensity) {
    const auto damping = fittedDamping(decaysOf(modes));
    // Not one with grain: `fitMaterial` analyses an isotropic body.
    auto isotropic =
        std::views::filter(materialLibrary(), [](const Material& known) { return !known.grain; });
    const auto& similar = *std::ranges::min_element(isotropic, {}, [&](const Material& known) {
        return distanceTo(known, damping, stiffnessOverDensity, modes);
    });
    MaterialFit fit;
    fit.material = similar;
    fit.resembles = similar.name;
    fit.material.damping = damping;
    if (stiffnessOverDensity)
        fit.material.youngsModulusPa = *stiffnessOverDensity * similar.densityKgPerM3;
    return fit;
}

} // namespace

std::optional<ModeMatch> matchModes(std::span<const MeasuredMode> measured,
                                    std::span<const double> objectHz) {
    if (objectHz.size() < 2 || measured.size() < 2)
        return {};
    const ModeDensity object(objectHz);
    const auto weights = weightsOf(measured);
    constexpr double step = deviation / 4;
    const double first = std::log(lowestRatio);
    std::vector<double> scores;
    for (double shift = first; shift < std::log(highestRatio); shift += step)
        scores.push_back(scoreAt(shift, measured, weights, object));
    const auto best = std::ranges::max_element(scores) - scores.begin();
    double shift = first + step * static_cast<double>(best);
    ModeMatch match;
    match.matched = settle(shift, measured, weights, object);
    if (scores[best] < convincing || match.matched.size() < 2)
        return {};
    match.frequencyRatio = std::exp(shift);
    match.score = scores[best];
    double second = scores[best] - nearlyAsGood;
    for (std::ptrdiff_t i = 0; i < std::ssize(scores); ++i)
        if (static_cast<double>(std::abs(i - best)) * step > 2 * matchedWithin &&
            scores[i] > second) {
            second = scores[i];
            match.other = std::exp(first + step * static_cast<double>(i));
        }
    return match;
}

Result<MaterialFit> fitDampingOnly(std::span<const MeasuredMode> measured) {
    if (measured.empty())
        return failure("There are no modes to fit a material to.");
    return fitWith(measured, {});
}

Result<std::optional<MaterialFit>> fitMaterial(std::span<const MeasuredMode> measured,
                                               const Mesh& mesh,
                                               AnalysisSettings settings,
                                               const WorkControl& control) {
    settings.material = *findMaterial("Steel");
    settings.listeningDirections.clear(); // radiation does not move the modes
    std::optional<ModeMatch> best;
    double bestPoissonRatio = 0;
    for (std::size_t i = 0; i < poissonRatios.size(); ++i) {
        const auto share = [](std::size_t count) { return double(count) / poissonRatios.size(); };
        settings.material.poissonRatio = poissonRatios[i];
        const auto object = analyse(mesh, settings, control.part(share(i), share(i + 1)));
        if (!object)
            return tl::unexpected(object.error());
        std::vector<double> frequenciesHz;
        for (const double eigenvalue : object->eigenvalues)
            frequenciesHz.push_back(std::sqrt(eigenvalue) / (2 * std::numbers::pi));
        auto match = matchModes(measured, frequenciesHz);
        if (match && (!best || match->score > best->score)) {
            best = std::move(match);
            bestPoissonRatio = poissonRatios[i];
        }
    }
    if (!best)
        return std::nullopt;
    const auto squared = [](double x) { return x * x; };
    std::vector<MeasuredMode> own;
    for (const std::size_t i : best->matched)
        own.push_back(measured[i]);
    auto fit = fitWith(own, settings.material.youngsModulusPa / settings.material.densityKgPerM3 *
                                squared(best->frequencyRatio));
    fit.material.poissonRatio = bestPoissonRatio;
    fit.matched = own.size();
    if (best->other)
        fit.otherRatio = squared(*best->other / best->frequencyRatio);
    return fit;
}

} // namespace idiophone
