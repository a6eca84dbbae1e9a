#include "Scene/SceneSound.h"

#include "Instrument/SharedSurfaceProfile.h"

#include <algorithm>

namespace idiophone {

SceneSound::SceneSound(const SceneCast& cast,
                       std::vector<SynthesiserSlot> slots,
                       double sampleRateHz,
                       std::uint64_t seed)
    : synth(std::move(slots), sampleRateHz, 2), cellSeconds(cellSamples / sampleRateHz),
      startSeconds(-cellSeconds) {
    std::vector<Surface> surfaces;
    for (const auto& role : cast.roles()) {
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

void SceneSound::beginCell(const CellOutput& cell) {
    startSeconds = static_cast<double>(cellsBegun++) * cellSeconds;
    synth.beginCell(cell);
}

bool SceneSound::strike(const SceneBlow& blow, const CellOutput& cell) {
    const double sample = (blow.seconds - startSeconds) * synth.sampleRateHz();
    return synth.strike(blow.slot, blow.strike,
                        std::clamp(sample, 0.0, std::nextafter(double{cellSamples}, 0.0)), cell);
}

void SceneSound::touch(std::span<const TouchState, TouchTracker::voiceCount> states,
                       const CellOutput& cell) {
    for (std::size_t k = 0; k < voices.size(); ++k) {
        auto& voice = voices[k];
        const auto& state = states[k];
        alignas(64) std::array<float, cellSamples> newtons;
        if (!press(voice, state, newtons))
            continue;
        for (std::size_t side = 0; side < 2; ++side)
            if (state.slots[side] < synth.slotCount())
                synth.applyForce(state.slots[side],
                                 {.contact = k,
                                  .start = {.points = {voice.last.points[side], {}}},
                                  .end = {.points = {state.points[side], {}}},
                                  .newtons = newtons},
                                 cell);
        voice.last = state;
    }
}

/// The force of a voice in this cell, if it has any.
bool SceneSound::press(Voice& voice,
                       const TouchState& state,
                       std::span<float, cellSamples> newtons) {
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

bool SceneSound::silent() const {
    return synth.silent();
}

} // namespace idiophone
