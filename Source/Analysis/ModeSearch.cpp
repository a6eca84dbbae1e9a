#include "Analysis/ModeSearch.h"

#include "Analysis/BandPoles.h"
#include "Analysis/RoomSeparation.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>

namespace idiophone {
namespace {

using Eigen::MatrixXd;

// Widths of the bands relative to their frequency. Narrow bands tell close modes apart. Wide bands
// find modes that decay before a narrow filter has passed.
constexpr double narrowestBandHz = 60, narrowShare = 0.125, wideShare = 0.5;
constexpr double narrowestCycles = 32;                // of a band, in the shortest recording
constexpr double lowestHz = 20, highestShare = 0.499; // of the sample rate
// T60 over two minutes counts as steady. A mode loses at most this part of critical damping; what
// decays faster belongs to the contact.
constexpr double slowestDecayPerSecond = 0.05, fastestDecayPerSecond = 3450, heaviestDamping = 0.05;
// Minimum energy that a mode alone explains, over the noise energy of one value: a constant and a
// term per recording.
constexpr double aboveNoise = 20, aboveNoiseEach = 8;
// Minimum energy of a mode beside a louder one: in decades at the same frequency, and more for each
// octave up to one. Two modes closer than their width are twins; a faint one mends the fit of the
// other for the room, and bends its decay.
constexpr double decadesBelow = 3, decadesPerOctave = 2.5, decadesBelowTwin = 1.5;
constexpr std::size_t mostOfOneSearch = 600, mostCandidates = 320;
constexpr double faintestCandidate = 1e-7; // energy relative to the loudest of the same search

double energyOf(const DampedSinusoid& mode) {
    double sum = 0;
    for (const auto& amplitude : mode.amplitudes)
        sum += std::norm(amplitude);
    return sum / mode.pole.decayPerSecond;
}

} // namespace

ModeSearch::ModeSearch(std::span<const RecordedStrike> of, const WorkControl& watch)
    : strikes(of), control(watch), highestHz(std::numeric_limits<double>::infinity()) {
    for (const auto& strike : strikes) {
        recordings.push_back(strike.decay);
        highestHz = std::min(highestHz, highestShare * strike.decay.sampleRateHz);
    }
}

Result<void> ModeSearch::run(std::size_t modeCount) {
    const JointFit nothing(recordings, {});
    auto fit = withMore(nothing, narrowShare, control.part(0, 0.3));
    fit = withMore(fit, wideShare, control.part(0.3, 0.5));
    if (control.isCancelled())
        return cancellation();
    fit.eliminate(floors(fit, steadyOnes(fit)), mostCandidates);
    const auto isSteady = steadyOnes(fit);
    const auto steadyCount =
        static_cast<std::size_t>(std::count(isSteady.begin(), isSteady.end(), true));
    found = fit.poles().size() - steadyCount;
    if (found > modeCount) {
        MatrixXd equal = MatrixXd::Constant(isSteady.size(), strikes.size(), 1e-30);
        for (std::size_t i = 0; i < isSteady.size(); ++i)
            if (isSteady[i])
                equal.row(i).setConstant(1e-60); // stays
        fit.eliminate(equal, modeCount + steadyCount);
    }
    control.report(0.5, "Fitting the modes");
    if (control.isCancelled())
        return cancellation();
    fit.refine(2);
    sort(fit);
    if (auto separated = separateRoom(control.part(0.6, 1)); !separated)
        return separated;
    // A tone may have turned out to be a mode after the selection.
    if (modes.size() > modeCount) {
        std::ranges::sort(modes, std::greater{}, energyOf);
        modes.resize(modeCount);
    }
    std::ranges::sort(modes, {}, [](const auto& mode) { return mode.pole.frequencyHz; });
    return {};
}

/// Sets `modes` and `steady`.
void ModeSearch::sort(const JointFit& fit) {
    modes.clear();
    steady.clear();
    const auto sinusoids = fit.sinusoids();
    const auto isSteady = steadyOnes(fit);
    for (std::size_t i = 0; i < sinusoids.size(); ++i)
        (isSteady[i] ? steady : modes).push_back(sinusoids[i]);
}

Result<void> ModeSearch::separateRoom(const WorkControl& watch) {
    const RoomSeparation separation(strikes, modes, steady);
    const auto room = separation.room(watch.part(0, 0.3));
    auto poles = plausible(separation.polesIn(room, watch.part(0.3, 1)));
    if (watch.isCancelled())
        return cancellation();
    for (const auto& tone : steady)
        poles.push_back(tone.pole);
    sort(JointFit(recordings, std::move(poles)));
    return {};
}

/// Returns the fit with modes of what it leaves, found in bands of this share of their frequency.
/// If the work is cancelled, the result is of no use.
JointFit ModeSearch::withMore(const JointFit& fit, double share, const WorkControl& watch) const {
    const auto sinusoids = fit.sinusoids();
    std::vector<DecayRecording> rests;
    for (std::size_t r = 0; r < recordings.size(); ++r)
        rests.push_back({.samples = without(recordings[r], sinusoids, r),
                         .sampleRateHz = recordings[r].sampleRateHz});
    auto poles = plausible(polesOf(rests, share, watch));
    std::ranges::copy(fit.poles(), std::back_inserter(poles));
    JointFit more(recordings, std::move(poles));
    const auto isCancelled = [&](double fraction) {
        watch.report(fraction, "Fitting the modes");
        return watch.isCancelled();
    };
    if (isCancelled(0.5))
        return fit;
    more.eliminate(floors(more, {}), mostCandidates);
    if (isCancelled(0.7))
        return fit;
    more.refine(3);
    more = JointFit(recordings, plausible(more.poles()));
    if (isCancelled(0.9))
        return fit;
    more.eliminate(floors(more, {}), mostCandidates);
    return more;
}

std::vector<DecayPole> ModeSearch::polesOf(std::span<const DecayRecording> rests,
                                           double share,
                                           const WorkControl& watch) const {
    double shortest = std::numeric_limits<double>::infinity();
    for (const auto& recording : recordings)
        shortest = std::min(shortest, recording.seconds());
    const double narrowest = std::max(narrowestBandHz, narrowestCycles / shortest);
    std::vector<BandPole> candidates;
    for (double low = lowestHz; low < highestHz && !watch.isCancelled();) {
        const double width = std::max(narrowest, share * low);
        std::ranges::copy(polesInBand(rests, low + width / 2, width),
                          std::back_inserter(candidates));
        low += width;
        const double done = std::log(low / lowestHz) / std::log(highestHz / lowestHz);
        watch.report(0.5 * std::min(1.0, done), "Searching for modes");
    }
    std::ranges::sort(candidates, std::greater{}, &BandPole::energy);
    candidates.resize(std::min(candidates.size(), mostOfOneSearch));
    std::vector<DecayPole> poles;
    for (const auto& [pole, energy] : candidates)
        if (energy > faintestCandidate * candidates.front().energy)
            poles.push_back(pole);
    return poles;
}

std::vector<DecayPole> ModeSearch::plausible(const std::vector<DecayPole>& poles) const {
    std::vector<DecayPole> result;
    for (auto pole : poles) {
        pole.decayPerSecond = std::max(pole.decayPerSecond, slowestDecayPerSecond);
        if (pole.frequencyHz >= lowestHz && pole.frequencyHz <= highestHz &&
            pole.decayPerSecond <=
                std::min(fastestDecayPerSecond,
                         heaviestDamping * 2 * std::numbers::pi * pole.frequencyHz))
            result.push_back(pole);
    }
    return result;
}

/// Returns the least energy of each pole in each recording. Without `isSteady`, only noise counts.
MatrixXd ModeSearch::floors(const JointFit& fit, const std::vector<bool>& isSteady) const {
    const auto& poles = fit.poles();
    const auto each = static_cast<double>(recordings.size());
    MatrixXd result(poles.size(), recordings.size());
    for (std::size_t i = 0; i < poles.size(); ++i) {
        for (std::size_t r = 0; r < recordings.size(); ++r)
            result(i, r) = (aboveNoise + aboveNoiseEach * each) *
                               strikes[r].noise.energyAt(poles[i].frequencyHz) +
                           1e-12;
        if (isSteady.empty())
            continue;
        double least = 0;
        for (std::size_t j = 0; j < poles.size(); ++j) {
            if (isSteady[j])
                continue;
            const double octaves = std::abs(std::log2(poles[i].frequencyHz / poles[j].frequencyHz));
            const bool isTwin = std::abs(poles[i].perSecond() - poles[j].perSecond()) <
                                std::max(poles[i].decayPerSecond, poles[j].decayPerSecond);
            const double decades = isTwin
                                       ? decadesBelowTwin
                                       : decadesBelow + decadesPerOctave * std::min(1.0, octaves);
            least = std::max(least, fit.ownEnergies().row(j).sum() * std::pow(10, -decades));
        }
        if (isSteady[i])
            result.row(i).setConstant(1e-30); // stays
        else
            result.row(i) = result.row(i).cwiseMax(least);
    }
    return result;
}

std::vector<bool> ModeSearch::steadyOnes(const JointFit& fit) const {
    const auto sinusoids = fit.sinusoids(); // ascending in frequency
    const auto isBeside = [&](std::size_t a, std::size_t b) {
        constexpr double nearRatio = 1.03;
        return b < sinusoids.size() &&
               std::abs(std::log(sinusoids[a].pole.frequencyHz / sinusoids[b].pole.frequencyHz)) <
                   std::log(nearRatio);
    };
    std::vector<bool> result;
    for (std::size_t i = 0; i < sinusoids.size(); ++i) {
        const bool isAlone = !isBeside(i, i + 1) && !isBeside(i, i - 1);
        bool isSteady = true;
        for (std::size_t r = 0; r < strikes.size(); ++r)
            isSteady =
                isSteady && strikes[r].isSteady(sinusoids[i].pole,
                                                std::abs(sinusoids[i].amplitudes[r]), isAlone);
        result.push_back(isSteady);
    }
    return result;
}

} // namespace idiophone
