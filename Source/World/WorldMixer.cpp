// SPDX-License-Identifier: Apache-2.0
#include "World/WorldMixer.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

constexpr double glideSeconds = 0.015; // about a frame: short, and moves without steps

std::vector<CellOutput>
cellsFor(std::size_t bodies, std::span<float> samplesOfBodies, const CellOutput& both) {
    if (!samplesOfBodies.empty())
        return cellsOfSlotsIn(samplesOfBodies);
    return std::vector<CellOutput>(bodies, both);
}

} // namespace

WorldMixer::WorldMixer(std::vector<SynthesiserSlot> slots,
                       const std::vector<Eigen::Vector3d>& middlesMetres,
                       const WorldSettings& settings)
    : events(settings.eventCapacity),
      synth(std::move(slots), settings.sampleRateHz, settings.listener ? 1 : 2),
      hasListener(settings.listener.has_value()), bodies(hasListener ? synth.slotCount() : 0,
                                                         settings.surfaces,
                                                         settings.listener.value_or(Listener{}),
                                                         settings.sampleRateHz,
                                                         settings.seed,
                                                         settings.head),
      strikes(settings.eventCapacity), places(middlesMetres),
      share(-std::expm1(-cellSamples / (settings.sampleRateHz * glideSeconds))),
      samples(hasListener ? synth.slotCount() * cellSamples : 0),
      cells(cellsFor(synth.slotCount(), samples, CellOutput(left, right))) {
    for (const auto& middle : middlesMetres)
        middles.push_back({middle, middle});
    const auto at = settings.listener.value_or(Listener{});
    position = {at.positionMetres, at.positionMetres};
    towards = {at.towardsMetres, at.towardsMetres};
    up = at.up;
    synth.setSettings(settings.synthesis);
    synth.settle();
}

void WorldMixer::take(const PlacedBody& placed) noexcept {
    middles[placed.body].goal = placed.middleMetres;
}

void WorldMixer::take(const Listener& moved) noexcept {
    position.goal = moved.positionMetres;
    towards.goal = moved.towardsMetres;
    up = moved.up;
}

void WorldMixer::take(const TimedStrike& timed) noexcept {
    const double sample =
        timed.seconds * synth.sampleRateHz() - static_cast<double>(cellsBegun) * cellSamples;
    strikes.schedule(timed.body, timed.strike, cellsBegun, std::max(sample, 0.0));
}

void WorldMixer::take(const MovedTouch& moved) noexcept {
    auto& touch = touches[moved.number];
    if (moved.state.pair != touch.goal.pair) { // begins softly at its own place
        touch.state = moved.state;
        touch.state.forceNewtons = 0;
    }
    touch.goal = moved.state;
    touch.isPressed = true;
}

void WorldMixer::take(const EndedTouch& ended) noexcept {
    touches[ended.number].goal.forceNewtons = 0;
    touches[ended.number].isPressed = false;
}

/// Leaves events in the queue while no more strikes can wait.
void WorldMixer::takeEvents() noexcept {
    Event event;
    while (strikes.freeSpace() > 0 && events.pop(event))
        std::visit([this](const auto& what) { take(what); }, event);
}

void WorldMixer::press(const BegunCell& cell) noexcept {
    for (std::size_t k = 0; k < touches.size(); ++k) {
        auto& touch = touches[k];
        if (touch.goal.pair == 0)
            continue;
        const auto glide = [this](double now, double goal) { return now + share * (goal - now); };
        auto state = touch.goal;
        state.forceNewtons = glide(touch.state.forceNewtons, touch.goal.forceNewtons);
        state.slideMetresPerSecond =
            glide(touch.state.slideMetresPerSecond, touch.goal.slideMetresPerSecond);
        state.rollMetresPerSecond =
            glide(touch.state.rollMetresPerSecond, touch.goal.rollMetresPerSecond);
        constexpr double unheardNewtons = 1e-6;
        if (!touch.isPressed && state.forceNewtons < unheardNewtons) {
            bodies.contacts.release(k, cell);
            touch = {};
            continue;
        }
        touch.state = state;
        bodies.contacts.press(k, state, cell);
    }
}

void WorldMixer::hear() noexcept {
    for (std::size_t k = 0; k < places.size(); ++k) {
        middles[k].advance(share);
        places[k] = middles[k].now;
    }
    position.advance(share);
    towards.advance(share);
    bodies.setListener({position.now, towards.now, up});
    bodies.hear(cells, places, {left, right});
}

void WorldMixer::beginCell() noexcept {
    takeEvents();
    const BegunCell cell{synth, cells, cellsBegun};
    synth.beginCell(cells);
    press(cell);
    leftOut += static_cast<std::int64_t>(strikes.strikeBefore(cellSamples, cell));
    if (hasListener)
        hear();
    for (std::size_t k = 0; k < cellSamples; ++k) {
        const float gain = gainNow + (gainGoal - gainNow) * static_cast<float>(k + 1) / cellSamples;
        left[k] *= gain;
        right[k] *= gain;
    }
    gainNow = gainGoal;
    clock.store(++cellsBegun * cellSamples, std::memory_order_relaxed);
    used = 0;
}

void WorldMixer::render(std::span<float> leftEar, std::span<float> rightEar) noexcept {
    const std::size_t count = std::min(leftEar.size(), rightEar.size());
    for (std::size_t done = 0; done < count;) {
        if (used == cellSamples)
            beginCell();
        const std::size_t length = std::min(count - done, cellSamples - used);
        std::copy_n(left.data() + used, length, leftEar.data() + done);
        std::copy_n(right.data() + used, length, rightEar.data() + done);
        used += length;
        done += length;
    }
}

bool WorldMixer::silent() const noexcept {
    return events.read_available() == 0 && strikes.empty() && synth.silent() && bodies.silent() &&
           std::ranges::none_of(touches, [](const Pressed& touch) { return touch.goal.pair != 0; });
}

} // namespace idiophone
