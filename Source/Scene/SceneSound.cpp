#include "Scene/SceneSound.h"

#include "Instrument/SharedSurfaceProfile.h"

#include <algorithm>
#include <cmath>

namespace idiophone {

SceneSound::SceneSound(const SceneCast& cast,
                       std::vector<SynthesiserSlot> slots,
                       double sampleRateHz,
                       std::uint64_t seed)
    : synth(std::move(slots), sampleRateHz, 1), head(cast.scene().listener),
      samples(synth.slotCount() * cellSamples),
      sources(synth.slotCount(), PlacedSource(sampleRateHz)),
      cellSeconds(cellSamples / sampleRateHz), startSeconds(-cellSeconds) {
    for (std::size_t slot = 0; slot < synth.slotCount(); ++slot)
        cells.emplace_back(
            std::span<float, cellSamples>(&samples[slot * cellSamples], cellSamples));
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

void SceneSound::beginCell() noexcept {
    startSeconds = static_cast<double>(cellsBegun++) * cellSeconds;
    synth.beginCell(cells);
}

bool SceneSound::strike(const SceneBlow& blow) noexcept {
    if (blow.slot >= cells.size())
        return false;
    const double sample = (blow.seconds - startSeconds) * synth.sampleRateHz();
    return synth.strike(blow.slot, blow.strike,
                        std::clamp(sample, 0.0, std::nextafter(double{cellSamples}, 0.0)),
                        cells[blow.slot]);
}

void SceneSound::touch(std::span<const TouchState, TouchTracker::voiceCount> states) noexcept {
    for (std::size_t k = 0; k < voices.size(); ++k) {
        auto& voice = voices[k];
        const auto& state = states[k];
        alignas(64) std::array<float, cellSamples> newtons;
        if (!press(voice, state, newtons))
            continue;
        for (std::size_t side = 0; side < 2; ++side)
            if (const auto slot = state.slots[side]; slot < cells.size())
                synth.applyForce(slot,
                                 {.contact = k,
                                  .start = {.points = {voice.last.points[side], {}}},
                                  .end = {.points = {state.points[side], {}}},
                                  .newtons = newtons},
                                 cells[slot]);
        voice.last = state;
    }
}

void SceneSound::finishCell(std::span<const Eigen::Vector3d> places,
                            const CellOutput& ears) noexcept {
    for (std::size_t ear = 0; ear < 2; ++ear)
        std::fill_n(ears[ear].data(), cellSamples, 0.0f);
    for (std::size_t slot = 0; slot < cells.size(); ++slot) {
        const auto cell = cells[slot][0];
        const bool sounds = std::ranges::any_of(cell, [](float x) { return x != 0; });
        if (sounds || !sources[slot].silent())
            sources[slot].add(cell, head.path(places[slot]), ears);
    }
}

/// The force of a voice in this cell, if it has any.
bool SceneSound::press(Voice& voice,
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

bool SceneSound::silent() const {
    return synth.silent() && std::ranges::all_of(sources, &PlacedSource::silent);
}

} // namespace idiophone
