#include "Instrument/LoudnessMatch.h"

#include "Instrument/SettingsOfParameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace idiophone {
namespace {

using enum ParameterId;

constexpr double largestGainDb = 40;
// The tolerance is 2 LU; the prediction's own error uses up the rest.
constexpr double maximumFromMiddleDb = 1.5;

void copyInto(ParameterValues& to,
              const ParameterValues& from,
              std::span<const ParameterId> parameters) noexcept {
    for (const auto parameter : parameters)
        to.set(parameter, from[parameter]);
}

/// `now` with the preset's material and mallet.
ParameterValues withOwn(ParameterValues now, const ParameterValues& own) noexcept {
    copyInto(now, own, materialFigures);
    copyInto(now, own, malletFigures);
    copyInto(now, own, std::array{material, mallet});
    return now;
}

} // namespace

ParameterValues valuesThatMatter(const ParameterValues& values) noexcept {
    ParameterValues result;
    copyInto(result, values,
             std::array{material, decay, size, thickness, keepPitch, tune, concertPitch,
                        strikeAlong, strikeAcross, radiation, letRing, contact});
    if (static_cast<int>(values[material]) == customMaterial)
        copyInto(result, values, materialFigures);
    if (values[letRing] == 0)
        result.set(releaseTime, values[releaseTime]);
    if (!strikes(values)) {
        result.set(contactSpeed, values[contactSpeed]);
        if (static_cast<int>(values[contact]) == rollContact)
            result.set(rollCoupling, values[rollCoupling]);
        return result;
    }
    copyInto(result, values,
             std::array{mallet, hardness, malletSpeed, malletFollow, velocityCurve, chatter,
                        modalPulse});
    if (static_cast<int>(values[mallet]) == customMallet)
        copyInto(result, values, malletFigures);
    return result;
}

void LoudnessMatch::prepare(const ParameterValues& now, int awaitedWheel) noexcept {
    const int wheelNow = wheel;
    state = atSongStart = {};
    songBegins = isSongStart = false;
    for (const int place : {awaitedWheel, HeldContacts::controllerAtRest, wheelNow}) {
        wheel = place;
        advance(now, std::numeric_limits<std::size_t>::max());
    }
    wasPrepared = hasPrepared = true;
}

std::size_t LoudnessMatch::advance(const ParameterValues& now) noexcept {
    const bool first = !std::exchange(hasPrepared, true);
    return advance(now, first ? std::numeric_limits<std::size_t>::max() : modesPerCell);
}

void LoudnessMatch::reset() noexcept {
    wheel = HeldContacts::controllerAtRest;
    state.working = songBegins = isSongStart = false;
    state.seen.reset();
    hasPrepared = wasPrepared;
}

std::size_t LoudnessMatch::advance(const ParameterValues& now, std::size_t modes) noexcept {
    if (now[matchLoudness] == 0)
        state.working = false;
    if (std::exchange(songBegins, false))
        returnToSongStart(now);
    if (!state.working)
        setGoal(now);
    std::size_t taken = 0;
    while (state.working && taken < modes) {
        taken += prediction.advance(modes - taken);
        if (!prediction.complete())
            break;
        auto& side = state.unknown();
        side.known() = {.goal = side.goal, .lufs = prediction.lufs()};
        beginNext();
    }
    if (!state.working && std::exchange(isSongStart, false))
        atSongStart = state;
    return taken;
}

void LoudnessMatch::returnToSongStart(const ParameterValues& now) noexcept {
    const auto beginsWith = [played = goalOf(now),
                             reference = goalOf(withOwn(now, ownValues))](const State& with) {
        return with.played.goal == played && with.reference.goal == reference;
    };
    isSongStart = true;
    if (atSongStart.seen && beginsWith(atSongStart))
        state = atSongStart;
    else if (state.working && beginsWith(state))
        return; // the work may take several passes of a short song
    state.working = false;
    state.seen.reset();
}

LoudnessMatch::Known& LoudnessMatch::Side::known() noexcept {
    return goal.wheel == HeldContacts::controllerAtRest ? atRest : away;
}

bool LoudnessMatch::Side::isKnown() noexcept {
    return known().goal == goal;
}

LoudnessMatch::Goal LoudnessMatch::goalOf(const ParameterValues& values) const noexcept {
    return {.values = valuesThatMatter(values),
            .wheel = strikes(values) ? HeldContacts::controllerAtRest : wheel};
}

void LoudnessMatch::setGoal(const ParameterValues& now) noexcept {
    const Goal seen{.values = now, .wheel = wheel};
    if (seen == state.seen)
        return;
    state.seen = seen;
    state.played.goal = goalOf(now);
    state.reference.goal = goalOf(withOwn(now, ownValues));
    if (now[matchLoudness] == 0 || state.played.goal == state.reference.goal)
        state.gainDb = 0;
    else
        beginNext();
}

/// Begins the next unknown prediction of the goal, or computes the gain if all are known.
void LoudnessMatch::beginNext() noexcept {
    state.working = !state.unknown().isKnown();
    if (!state.working) {
        state.gainDb = gainOfKnown();
        return;
    }
    const auto& goal = state.unknown().goal;
    prediction = PhrasePrediction(phrase, goal.values, goal.wheel);
}

double LoudnessMatch::gainOfKnown() noexcept {
    const auto& reference = state.reference.known().lufs;
    const auto& played = state.played.known().lufs;
    PhrasePrediction::Loudness gains;
    for (std::size_t k = 0; k < gains.size(); ++k)
        gains[k] = reference[k] - played[k];
    const double mean =
        std::accumulate(gains.begin(), gains.end(), 0.0) / static_cast<double>(gains.size());
    if (!std::isfinite(mean))
        return 0;
    const double middle = gains[PhrasePrediction::middleVelocity];
    const double gain =
        std::clamp(mean, middle - maximumFromMiddleDb, middle + maximumFromMiddleDb);
    return std::clamp(gain, -largestGainDb, largestGainDb);
}

} // namespace idiophone
