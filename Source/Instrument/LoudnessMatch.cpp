#include "Instrument/LoudnessMatch.h"

#include "Instrument/SettingsOfParameters.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace idiophone {
namespace {

using enum ParameterId;

constexpr double largestGainDb = 40;
// What 2 LU leave beside the error of the prediction.
constexpr double farthestFromMiddleDb = 1.5;

void copyInto(ParameterValues& to,
              const ParameterValues& from,
              std::span<const ParameterId> parameters) noexcept {
    for (const auto parameter : parameters)
        to.set(parameter, from[parameter]);
}

void copyInto(ParameterValues& to,
              const ParameterValues& from,
              std::initializer_list<ParameterId> parameters) noexcept {
    copyInto(to, from, std::span(parameters.begin(), parameters.size()));
}

/// `now` with the preset's material and mallet.
ParameterValues withOwn(ParameterValues now, const ParameterValues& own) noexcept {
    copyInto(now, own, materialFigures);
    copyInto(now, own, malletFigures);
    copyInto(now, own, {material, mallet});
    return now;
}

} // namespace

ParameterValues valuesThatMatter(const ParameterValues& values) noexcept {
    ParameterValues result;
    copyInto(result, values,
             {material, size, thickness, tune, concertPitch, strikeAlong, strikeAcross, radiation,
              letRing, contact});
    if (static_cast<int>(values[material]) == customMaterial)
        copyInto(result, values, materialFigures);
    if (values[letRing] == 0)
        copyInto(result, values, {releaseTime});
    if (!strikes(values)) {
        copyInto(result, values, {contactSpeed});
        if (static_cast<int>(values[contact]) == rollContact)
            copyInto(result, values, {rollCoupling});
        return result;
    }
    copyInto(result, values, {mallet, malletSpeed, velocityCurve, chatter, modalPulse});
    if (static_cast<int>(values[mallet]) == customMallet)
        copyInto(result, values, malletFigures);
    return result;
}

LoudnessMatch::LoudnessMatch(std::shared_ptr<const Instrument> instrument,
                             const Surface& surface,
                             double sampleRateHz,
                             const ParameterValues& own)
    : phrase(std::move(instrument), surface, sampleRateHz), ownValues(own) {}

PhrasePrediction::Loudness
LoudnessMatch::predictedLufs(const ParameterValues& values) const noexcept {
    return predictedLoudness(phrase, values, wheel);
}

void LoudnessMatch::prepare(const ParameterValues& now) noexcept {
    state = {};
    advance(now, std::numeric_limits<std::size_t>::max());
    state.prepared = true;
    start = state;
}

std::size_t LoudnessMatch::advance(const ParameterValues& now) noexcept {
    const bool first = !std::exchange(state.prepared, true);
    return advance(now, first ? std::numeric_limits<std::size_t>::max() : modesPerCell);
}

void LoudnessMatch::reset() noexcept {
    state = start;
    wheel = HeldContacts::controllerAtRest;
}

std::size_t LoudnessMatch::advance(const ParameterValues& now, std::size_t modes) noexcept {
    if (now[matchLoudness] == 0)
        state.working = false;
    if (!state.working)
        setGoal(now);
    std::size_t taken = 0;
    while (state.working && taken < modes) {
        taken += prediction.advance(modes - taken);
        if (!prediction.complete())
            break;
        auto& known = state.onReference ? state.reference : state.played;
        known.valid = true;
        known.goal = state.onReference ? state.referenceGoal : state.playedGoal;
        known.lufs = prediction.lufs();
        beginNext();
    }
    return taken;
}

LoudnessMatch::Goal LoudnessMatch::goalOf(const ParameterValues& values) const noexcept {
    return {.values = valuesThatMatter(values), .wheel = strikes(values) ? 0 : wheel};
}

void LoudnessMatch::setGoal(const ParameterValues& now) noexcept {
    const Goal seen{.values = now, .wheel = wheel};
    if (seen == state.seen)
        return;
    state.seen = seen;
    state.playedGoal = goalOf(now);
    state.referenceGoal = goalOf(withOwn(now, ownValues));
    if (now[matchLoudness] == 0 || state.playedGoal == state.referenceGoal)
        state.gainDb = 0;
    else
        beginNext();
}

/// What is still unknown of the goal, or its gain.
void LoudnessMatch::beginNext() noexcept {
    const auto isKnown = [](const Known& known, const Goal& goal) {
        return known.valid && known.goal == goal;
    };
    state.onReference = !isKnown(state.reference, state.referenceGoal);
    state.working = state.onReference || !isKnown(state.played, state.playedGoal);
    if (!state.working) {
        state.gainDb = gainOfKnown();
        return;
    }
    const auto& goal = state.onReference ? state.referenceGoal : state.playedGoal;
    prediction.begin(phrase, goal.values, goal.wheel);
}

double LoudnessMatch::gainOfKnown() const noexcept {
    PhrasePrediction::Loudness gains;
    for (std::size_t k = 0; k < gains.size(); ++k)
        gains[k] = state.reference.lufs[k] - state.played.lufs[k];
    const double mean =
        std::accumulate(gains.begin(), gains.end(), 0.0) / static_cast<double>(gains.size());
    if (!std::isfinite(mean))
        return 0;
    const double middle = gains[PhrasePrediction::middleVelocity];
    const double gain =
        std::clamp(mean, middle - farthestFromMiddleDb, middle + farthestFromMiddleDb);
    return std::clamp(gain, -largestGainDb, largestGainDb);
}

} // namespace idiophone
