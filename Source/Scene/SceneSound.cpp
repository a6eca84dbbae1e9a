#include "Scene/SceneSound.h"

namespace idiophone {

SceneSound::SceneSound(const SceneAssets& assets,
                       std::vector<SynthesiserSlot> slots,
                       double sampleRateHz,
                       std::uint64_t seed,
                       const std::shared_ptr<const HeadResponses>& head)
    : synth(std::move(slots), sampleRateHz, 1),
      ears(assets.scene().listener, head, synth.slotCount(), sampleRateHz),
      voices(assets, sampleRateHz, seed), samples(synth.slotCount() * cellSamples),
      cells(cellsOfSlotsIn(samples)), crowded(crowdedCapacity),
      cellSeconds(cellSamples / sampleRateHz), startSeconds(-cellSeconds) {}

void SceneSound::beginCell() noexcept {
    startSeconds = static_cast<double>(cellsBegun++) * cellSeconds;
    synth.beginCell(cells);
}

bool SceneSound::strike(const SceneImpact& impact) noexcept {
    if (impact.slot >= cells.size())
        return false;
    const double sample = (impact.seconds - startSeconds) * synth.sampleRateHz();
    return crowded.strike(impact.slot, impact.strike, sample, begunCell());
}

void SceneSound::touch(std::span<const TouchState, TouchTracker::voiceCount> states) noexcept {
    for (std::size_t k = 0; k < states.size(); ++k)
        voices.press(k, states[k], synth, cells);
}

void SceneSound::finishCell(std::span<const Eigen::Vector3d> places,
                            const CellOutput& heard) noexcept {
    crowded.strikeBefore(cellSamples, begunCell());
    ears.hear(cells, places, heard);
}

} // namespace idiophone
