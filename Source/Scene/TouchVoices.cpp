#include "Scene/TouchVoices.h"

#include "Instrument/SharedSurfaceProfile.h"

#include <algorithm>

namespace idiophone {

TouchVoices::TouchVoices(const SceneAssets& assets, double sampleRateHz, std::uint64_t seed) {
    std::vector<Surface> surfaces;
    for (const auto& role : assets.roles()) {
        auto known = std::ranges::find(surfaces, role.sound);
        if (known == surfaces.end())
            known = surfaces.insert(known, role.sound);
        surfaceOfRole.push_back(static_cast<std::size_t>(known - surfaces.begin()));
    }
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
                        const BegunCell& cell) noexcept {
    auto& voice = voices[index];
    alignas(64) std::array<float, cellSamples> newtons;
    if (!render(voice, state, newtons))
        return;
    for (std::size_t side = 0; side < 2; ++side)
        if (const auto slot = state.slots[side]; slot < cell.cellsOfSlots.size())
            cell.synthesiser.applyForce(slot,
                                        {.contact = index,
                                         .start = {.points = {voice.last.points[side], {}}},
                                         .end = {.points = {state.points[side], {}}},
                                         .newtons = newtons},
                                        cell.cellsOfSlots[slot]);
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

/// Renders the force of a voice in this cell. Returns false if it has none.
bool TouchVoices::render(Voice& voice,
                         const TouchState& state,
                         std::span<float, cellSamples> newtons) noexcept {
    if (state.pair == 0)
        return false;
    if (state.pair != voice.last.pair) {
        voice.surface = surfaceOfRole[state.soundRole];
        voice.slides[voice.surface].reset();
        voice.rolls[voice.surface].reset();
        voice.last = state;
    }
    alignas(64) std::array<float, cellSamples> rolling;
    const bool slides = voice.slides[voice.surface].render(
        {state.slideMetresPerSecond, state.forceNewtons}, newtons);
    const bool rolls =
        voice.rolls[voice.surface].render({state.rollMetresPerSecond, state.forceNewtons}, rolling);
    for (std::size_t i = 0; i < newtons.size(); ++i)
        newtons[i] += rolling[i];
    return slides || rolls;
}

} // namespace idiophone
