#include "Analysis/RoomSeparation.h"

#include "Analysis/JointFit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace idiophone {
namespace {

constexpr std::size_t bandsOfRoom = 12;
// Width of a band: the filter must pass before its modes have decayed.
constexpr double narrowestHz = 60, narrowestCycles = 32, widthsOfMode = 12;
constexpr std::size_t mostModes = 8;                  // of a band
constexpr double passedShare = 0.5, coreShare = 0.25; // of a band's width, from its centre
/// A mode whose own band is wider than this many widths has decayed behind the filter.
constexpr double widestMode = 2;
/// The most that a band's modes may lose in a room, relative to their energy.
constexpr double unexplained = 2e-3;

double energyOf(const DampedSinusoid& mode) {
    double sum = 0;
    for (const auto& amplitude : mode.amplitudes)
        sum += std::norm(amplitude);
    return sum / mode.pole.decayPerSecond;
}

double energyOf(std::span<const double> samples) {
    return std::transform_reduce(samples.begin(), samples.end(), 0.0, std::plus{},
                                 [](double sample) { return sample * sample; });
}

} // namespace

RoomSeparation::RoomSeparation(std::span<const RecordedStrike> of,
                               std::span<const DampedSinusoid> ofObject,
                               std::span<const DampedSinusoid> steady)
    : strikes(of), modes(ofObject) {
    for (std::size_t r = 0; r < strikes.size(); ++r) {
        const double rate = strikes[r].decay.sampleRateHz;
        const DecayRecording noTones{without(strikes[r].decay, steady, r), rate};
        rests.push_back({without(noTones, modes, r), rate});
    }
    chooseBands();
}

void RoomSeparation::chooseBands() {
    double shortest = std::numeric_limits<double>::infinity();
    for (const auto& rest : rests)
        shortest = std::min(shortest, rest.seconds());
    const auto widthFor = [&](std::size_t mode) {
        return std::max(
            {narrowestHz, narrowestCycles / shortest, widthsOfMode * modes[mode].pole.widthHz()});
    };
    std::vector<std::size_t> loudestFirst(modes.size());
    std::iota(loudestFirst.begin(), loudestFirst.end(), 0);
    std::ranges::stable_sort(loudestFirst, std::greater{},
                             [&](std::size_t mode) { return energyOf(modes[mode]); });
    std::vector<bool> done(modes.size());
    for (const std::size_t centre : loudestFirst) {
        if (done[centre])
            continue;
        done[centre] = true;
        const double hz = modes[centre].pole.frequencyHz, width = widthFor(centre);
        Band band{.all = {.centreHz = hz, .widthHz = width, .modes = {centre}}, .own = {centre}};
        for (const std::size_t mode : loudestFirst) {
            const double offset = std::abs(modes[mode].pole.frequencyHz - hz);
            if (mode == centre || offset > passedShare * width ||
                widthFor(mode) > widestMode * width || band.all.modes.size() >= mostModes)
                continue;
            band.all.modes.push_back(mode);
            if (offset <= coreShare * width && !done[mode]) {
                done[mode] = true;
                band.own.push_back(mode);
            }
        }
        bands.push_back(std::move(band));
    }
}

RoomEchoes RoomSeparation::room(const WorkControl& control) const {
    std::vector<RoomEchoes> rooms{{}};
    for (const double decibels : {-40.0, -35.0, -30.0, -25.0, -20.0})
        for (const double t60 : {0.2, 0.4, 0.8})
            rooms.push_back(
                {.energy = std::pow(10, decibels / 10), .decayPerSecond = std::log(1000) / t60});
    std::vector<double> likelihoods(rooms.size());
    const std::size_t judges = std::min(bands.size(), bandsOfRoom);
    for (std::size_t b = 0; b < judges && !control.isCancelled(); ++b) {
        control.report(static_cast<double>(b) / static_cast<double>(judges), "Separating the room");
        const EchoedBand band(strikes, rests, modes, bands[b].all);
        for (std::size_t i = 0; band.isUsable() && i < rooms.size(); ++i)
            likelihoods[i] += EchoedBand(band).fit(rooms[i]);
    }
    const auto best = std::ranges::max_element(likelihoods) - likelihoods.begin();
    return rooms[static_cast<std::size_t>(best)];
}

std::vector<DecayPole> RoomSeparation::polesIn(const RoomEchoes& room,
                                               const WorkControl& control) const {
    std::vector<DecayPole> poles;
    for (std::size_t b = 0; b < bands.size() && !control.isCancelled(); ++b) {
        control.report(static_cast<double>(b) / static_cast<double>(bands.size()),
                       "Separating the room");
        EchoedBand separated(strikes, rests, modes, bands[b].all);
        bool isBetter = separated.isUsable();
        if (isBetter) {
            separated.fit(room);
            isBetter = explainsEnough(separated, bands[b]);
        }
        for (const std::size_t mode : bands[b].own) {
            if (!isBetter) {
                poles.push_back(modes[mode].pole);
                continue;
            }
            const auto kept = std::ranges::find(separated.modes(), mode);
            if (kept != separated.modes().end())
                poles.push_back(
                    separated.pole(static_cast<std::size_t>(kept - separated.modes().begin())));
        }
    }
    return poles;
}

/// Compares over the whole recordings, because the band leaves out the strike.
bool RoomSeparation::explainsEnough(const EchoedBand& separated, const Band& band) const {
    std::vector<DampedSinusoid> added;
    for (const std::size_t mode : band.all.modes) {
        added.push_back(modes[mode]);
        for (auto& amplitude : added.back().amplitudes)
            amplitude = -amplitude;
    }
    std::vector<DecayRecording> whole;
    for (std::size_t r = 0; r < rests.size(); ++r)
        whole.push_back({without(rests[r], added, r), rests[r].sampleRateHz});
    std::vector<DecayPole> poles;
    for (std::size_t i = 0; i < separated.modes().size(); ++i)
        poles.push_back(separated.pole(i));
    const auto sinusoids = JointFit(whole, poles).sinusoids();
    double energy = 0, restBefore = 0, rest = 0;
    for (std::size_t r = 0; r < rests.size(); ++r) {
        energy += energyOf(whole[r].samples);
        restBefore += energyOf(rests[r].samples);
        rest += energyOf(without(whole[r], sinusoids, r));
    }
    return rest - restBefore <= unexplained * (energy - restBefore);
}

} // namespace idiophone
