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
// The tolerance is 2 LU, and the prediction's own error may be the remaining 0.5 LU.
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
             {material, size, thickness, keepPitch, tune, concertPitch, strikeAlong, strikeAcross,
              radiation, letRing, contact});
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
    copyInto(result, values,
             {mallet, malletSpeed, malletFollow, velocityCurve, chatter, modalPulse});
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
        auto& side = state.onReference ? state.reference : state.played;
        side.known() = {.valid = true, .goal = side.goal, .lufs = prediction.lufs()};
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
    return known().valid && known().goal == goal;
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
    state.onReference = !state.reference.isKnown();
    state.working = state.onReference || !state.played.isKnown();
    if (!state.working) {
        state.gainDb = gainOfKnown();
        return;
    }
    const auto& goal = (state.onReference ? state.reference : state.played).goal;
    prediction.begin(phrase, goal.values, goal.wheel);
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
        std::clamp(mean, middle - farthestFromMiddleDb, middle + farthestFromMiddleDb);
    return std::clamp(gain, -largestGainDb, largestGainDb);
}

} // namespace idiophone
