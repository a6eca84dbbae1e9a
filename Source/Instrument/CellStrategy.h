// How the notes of an instrument sound in cells: through mallets that strike its objects, or
// through bodies that move on a stage.
#pragma once

#include "Instrument/Stage.h"
#include "Instrument/StereoSpan.h"
#include "Instrument/StrikeScheduler.h"
#include "Synth/AlignedVector.h"
#include "Synth/CellOutput.h"
#include "Synth/Synthesiser.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace idiophone {

/// A cell of sound: both channels of each output, and where each slot sounds.
struct StereoCell {
    struct Channels {
        alignas(64) std::array<float, cellSamples> left{};
        alignas(64) std::array<float, cellSamples> right{};

        CellOutput output() { return {left, right}; }
    };

    std::array<Channels, maximumOutputs> channels;
    std::size_t outputsInUse = 1;     ///< the main one, up to the last with a slot
    AlignedVector<float> slotSamples; ///< [slots, 64] if each slot has samples of its own
    std::vector<CellOutput> slots;

    std::span<Channels> used() { return std::span(channels).first(outputsInUse); }
    std::span<const Channels> used() const { return std::span(channels).first(outputsInUse); }
    CellOutput mixed() { return channels.front().output(); }
    /// Lets the slots sound on these outputs, from 0 on [slots].
    void route(std::span<const std::uint8_t> outputsOfSlots) {
        outputsInUse = 1;
        for (std::size_t slot = 0; slot < slots.size(); ++slot) {
            slots[slot] = channels[outputsOfSlots[slot]].output();
            outputsInUse = std::max(outputsInUse, std::size_t{outputsOfSlots[slot]} + 1);
        }
    }
};

/// `layOut` allocates. The rest is for the audio thread and neither allocates, locks nor throws.
class CellStrategy {
public:
    virtual ~CellStrategy() = default;

    /// Gives a cell the samples of its slots, which sound on the main output.
    virtual void layOut(StereoCell& cell, std::size_t slotCount) const = 0;
    /// Overwrites the outputs with the sound of ringing modes.
    virtual void begin(Synthesiser& synthesiser, StereoCell& cell) = 0;
    /// Completes the newest cell, after ringing and held sounds.
    virtual void finish(const BegunCell&, StrikeScheduler&, StereoCell&) {}
    /// Fades forces of the strategy's own out over a cell.
    virtual void fadeForces(Synthesiser&, StereoCell&) {}
    /// Returns whether notes strike or press with mallets, and dampers follow keys.
    virtual bool hasMallets() const = 0;
};

/// Slots share the outputs, and strikes act within a cell.
class MalletCells final : public CellStrategy {
public:
    void layOut(StereoCell& cell, std::size_t slotCount) const override {
        cell.slots.assign(slotCount, cell.mixed());
    }
    void begin(Synthesiser& synthesiser, StereoCell& cell) override {
        if (cell.outputsInUse == 1)
            return synthesiser.beginCell(cell.mixed());
        for (auto& output : cell.used())
            output.output().clear();
        synthesiser.beginCell(cell.slots);
    }
    bool hasMallets() const override { return true; }
};

/// Each slot has its own samples, which the listener's ears mix. The ears process whole cells, so
/// every strike in a cell must be known when it begins.
class StageCells final : public CellStrategy {
public:
    explicit StageCells(StagePlayer& played) : performance(played) {}

    void layOut(StereoCell& cell, std::size_t slotCount) const override {
        cell.slotSamples.resize(slotCount * cellSamples);
        cell.slots = cellsOfSlotsIn(cell.slotSamples);
    }
    void begin(Synthesiser& synthesiser, StereoCell& cell) override {
        synthesiser.beginCell(cell.slots);
    }
    void finish(const BegunCell& begun, StrikeScheduler& strikes, StereoCell& cell) override {
        performance.sound(begun.index, begun.synthesiser, cell.slots);
        strikes.strikeBefore(cellSamples, begun);
        performance.hear(cell.slots, cell.mixed());
    }
    void fadeForces(Synthesiser& synthesiser, StereoCell& cell) override {
        performance.release(synthesiser, cell.slots);
    }
    bool hasMallets() const override { return false; }

private:
    StagePlayer& performance;
};

} // namespace idiophone
