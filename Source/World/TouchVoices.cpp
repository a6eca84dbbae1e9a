// SPDX-License-Identifier: Apache-2.0
#include "World/TouchVoices.h"

#include "Synth/SharedSurfaceProfile.h"

#include <algorithm>

namespace idiophone {

TouchVoices::TouchVoices(std::span<const Surface> surfaces,
                         double sampleRateHz,
                         std::uint64_t seed) {
    for (const auto& surface : surfaces) {
        const auto profile = sharedSurfaceProfile(surface, sampleRateHz);
        for (std::size_t k = 0; k < voices.size(); ++k) {
            voices[k].slides.emplace_back(profile, seed * 2 * voices.size() + 2 * k);
            auto& roll =
                voices[k].rolls.emplace_back(profile, seed * 2 * voices.size() + 2 * k + 1);
            roll.setSettings({.kind = ContactKind::roll});
        }
    }
}

void TouchVoices::press(std::size_t index,
                        const TouchState& state,
                        const BegunCell& cell,
                        std::size_t rollSlots) noexcept {
    auto& voice = voices[index];
    alignas(64) std::array<float, cellSamples> sliding, rolling;
    const auto [slides, rolls] = render(voice, state, sliding, rolling);
    if (!slides && !rolls)
        return;
    const auto apply = [&](ForceSamples newtons, std::size_t shift) {
        for (std::size_t side = 0; side < 2; ++side) {
            if (state.slots[side] >= cell.cellsOfSlots.size())
                continue;
            const std::size_t slot = state.slots[side] + shift;
            cell.synthesiser.applyForce(slot,
                                        {.contact = index,
                                         .start = {.points = {voice.last.points[side], {}}},
                                         .end = {.points = {state.points[side], {}}},
                                         .newtons = newtons},
                                        cell.cellsOfSlots[slot]);
        }
    };
    if (rollSlots == 0) {
        for (std::size_t i = 0; i < cellSamples; ++i)
            sliding[i] += rolling[i];
        apply(sliding, 0);
    } else {
        if (slides)
            apply(sliding, 0);
        if (rolls)
            apply(rolling, rollSlots);
    }
    voice.last = state;
}

void TouchVoices::release(std::size_t index, const BegunCell& cell) noexcept {
    auto state = voices[index].last;
    state.forceNewtons = 0;
    press(index, state, cell);
}

void TouchVoices::reset() noexcept {
    for (auto& voice : voices)
        voice.last = {};
}

/// Renders both forces of a voice in this cell. One that does not sound is all zeros.
TouchVoices::Sounding TouchVoices::render(Voice& voice,
                                          const TouchState& state,
                                          ForceSamples sliding,
                                          ForceSamples rolling) noexcept {
    if (state.pair == 0)
        return {};
    if (state.pair != voice.last.pair) {
        voice.surface = state.surface;
        voice.slides[voice.surface].reset();
        voice.rolls[voice.surface].reset();
        voice.last = state;
    }
    const double force = state.forceNewtons;
    return {
        .slides = voice.slides[voice.surface].render({state.slideMetresPerSecond, force}, sliding),
        .rolls = voice.rolls[voice.surface].render({state.rollMetresPerSecond, force}, rolling)};
}

} // namespace idiophone
