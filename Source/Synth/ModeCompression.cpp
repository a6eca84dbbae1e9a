// SPDX-License-Identifier: Apache-2.0
#include "Synth/ModeCompression.h"

#include "Synth/PoleLawKernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace idiophone {

namespace {

constexpr double samePole = 1e-9;
// Ratios of decay times that cannot be told apart.
constexpr double minimumLikeDecay = 0.75, maximumLikeDecay = 1.4;
constexpr double fullTurn = 2 * std::numbers::pi;

/// The first mode of a group, with the values that all others are compared with.
struct FirstMode {
    FirstMode(const ModalPole& first, const ModeDamping& firstDamping, double compression) noexcept
        : pole(first), damping(firstDamping), oscillates(isOscillating(first)),
          frequency(oscillates ? dampedFrequency(first) : 0),
          noticeable(oscillates ? fullTurn * compression * discriminationHz(frequency / fullTurn)
                                : 0) {}

    bool canMerge(const ModalPole& next, const ModeDamping& nextDamping) const noexcept {
        const bool isAlike = nextDamping == damping;
        if (!isAlike && (next.damping < minimumLikeDecay * pole.damping ||
                         next.damping > maximumLikeDecay * pole.damping))
            return false;
        if (isAlike && std::abs(next.stiffness - pole.stiffness) <= samePole * pole.stiffness)
            return true;
        if (!oscillates || !isOscillating(next))
            return false;
        // Compare squares, because a root for every mode would dominate the cost.
        const double meanDecay = (pole.damping + next.damping) / 4;
        const double tolerance = std::min(noticeable, meanDecay);
        const double squared = next.stiffness - next.damping * next.damping / 4;
        const double low = std::max(frequency - tolerance, 0.0);
        const double high = frequency + tolerance;
        return squared <= high * high && squared >= low * low;
    }

    ModalPole pole;
    ModeDamping damping;
    bool oscillates;
    double frequency;
    double noticeable;
};

} // namespace

double discriminationHz(double frequencyHz) noexcept {
    return frequencyHz < 2000 ? 1.5 + (frequencyHz - 20) * (5 - 1.5) / (2000 - 20)
                              : 5 + (frequencyHz - 2000) * (300.0 - 5) / (22000 - 2000);
}

std::size_t groupModes(std::span<const double> referenceEigenvalues,
                       const PoleLaw& law,
                       double compression,
                       std::span<std::int32_t> groupStarts,
                       std::span<const ModeDamping> dampings,
                       std::span<const std::uint8_t> kinds,
                       std::span<const std::complex<float>> gains) noexcept {
    constexpr std::size_t batch = 64;
    // The last pole of the batch before, and a batch.
    std::array<double, 1 + batch> stiffness, dampingPerSecond;
    std::array<std::uint8_t, batch> mayMerge;
    stiffness.fill(1);
    dampingPerSecond.fill(0);
    std::size_t groups = 0;
    std::size_t start = 0;
    ModalPole startPole;
    std::optional<FirstMode> first; // of the group, once a mode is compared with it
    for (std::size_t i = 0; i < referenceEigenvalues.size(); ++i) {
        const std::size_t place = i % batch;
        if (place == 0) {
            const std::size_t count = std::min(batch, referenceEigenvalues.size() - i);
            stiffness[0] = stiffness[batch];
            dampingPerSecond[0] = dampingPerSecond[batch];
            polesOfLaw(law, referenceEigenvalues.subspan(i, count),
                       dampings.empty() ? dampings : dampings.subspan(i, count),
                       stiffness.data() + 1, dampingPerSecond.data() + 1);
            findNeighbours(stiffness.data() + 1, dampingPerSecond.data() + 1, batch, compression,
                           mayMerge.data());
        }
        const ModeDamping damping = dampingOf(dampings, i);
        const ModalPole pole{stiffness[1 + place], dampingPerSecond[1 + place]};
        const bool isOfKind = kinds.empty() || kinds[i] == kinds[start];
        if (groups > 0 && (mayMerge[place] != 0 || i - start > 1) && isOfKind &&
            i - start < maximumGroup && !isShared(gains, start) && !isShared(gains, i)) {
            if (!first)
                first.emplace(startPole, dampingOf(dampings, start), compression);
            if (first->canMerge(pole, damping))
                continue;
        }
        groupStarts[groups++] = static_cast<std::int32_t>(i);
        start = i;
        startPole = pole;
        first.reset();
    }
    groupStarts[groups] = static_cast<std::int32_t>(referenceEigenvalues.size());
    return groups;
}

double mergedEigenvalue(std::span<const double> referenceEigenvalues,
                        std::span<const double> weights) noexcept {
    if (referenceEigenvalues.front() == referenceEigenvalues.back())
        return referenceEigenvalues.front();
    const double first = std::sqrt(referenceEigenvalues.front());
    double sum = 0;
    double total = 0;
    for (std::size_t i = 0; i < referenceEigenvalues.size(); ++i) {
        sum += weights[i] * (std::sqrt(referenceEigenvalues[i]) - first);
        total += weights[i];
    }
    const double mean = total > 0 ? first + sum / total : first;
    return mean * mean;
}

ModeDamping mergedDamping(std::span<const ModeDamping> dampings,
                          std::span<const double> weights) noexcept {
    const ModeDamping first = dampings.front();
    ModeDamping sum{.scale = 0, .extraPerSecond = 0};
    double total = 0;
    for (std::size_t i = 0; i < dampings.size(); ++i) {
        sum.scale += weights[i] * (dampings[i].scale - first.scale);
        sum.extraPerSecond += weights[i] * (dampings[i].extraPerSecond - first.extraPerSecond);
        total += weights[i];
    }
    return total > 0 ? ModeDamping{first.scale + sum.scale / total,
                                   first.extraPerSecond + sum.extraPerSecond / total}
                     : first;
}

void findLostShares(std::span<const double> referenceEigenvalues,
                    const PoleLaw& law,
                    std::span<float> shares,
                    std::span<const ModeDamping> dampings) noexcept {
    const std::size_t count = std::min(referenceEigenvalues.size(), maximumGroup);
    std::array<double, maximumGroup> decays;
    std::array<double, maximumGroup> frequencies;
    for (std::size_t i = 0; i < count; ++i) {
        const ModalPole pole = law.pole(referenceEigenvalues[i], dampingOf(dampings, i));
        decays[i] = pole.damping / 2;
        frequencies[i] = dampedFrequency(pole);
    }
    std::size_t pair = 0;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j) {
            const double a = decays[i] + decays[j];
            const double delta = frequencies[i] - frequencies[j];
            const double both = a * a + delta * delta;
            shares[pair++] = both > 0 ? static_cast<float>(delta * delta / both) : 0.0f;
        }
}

std::complex<float> mergedResidue(std::span<const std::complex<float>> residues,
                                  std::span<const float> lostShares) noexcept {
    std::complex<double> sum = 0;
    for (const auto& residue : residues)
        sum += residue;
    // With a²/(a² + Δ²) written as 1 − Δ²/(a² + Δ²), equal poles leave |Σr|² without rounding.
    double lost = 0;
    std::size_t pair = 0;
    for (std::size_t i = 0; i < residues.size(); ++i)
        for (std::size_t j = i + 1; j < residues.size(); ++j) {
            const std::complex<double> a = residues[i], b = residues[j];
            lost += 2 * (a.real() * b.real() + a.imag() * b.imag()) *
                    static_cast<double>(lostShares[pair++]);
        }
    if (lost == 0)
        return std::complex<float>(sum);
    const double whole = std::norm(sum);
    const double left = std::max(whole - lost, 0.0);
    return std::complex<float>(whole > 0 ? std::sqrt(left / whole) * sum : std::sqrt(left));
}

} // namespace idiophone
