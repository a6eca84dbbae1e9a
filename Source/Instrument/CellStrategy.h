// How the notes of an instrument sound in cells: through mallets that strike its objects, or
// through bodies that move on a stage.
#pragma once

#include "Instrument/Stage.h"
#include "Instrument/StrikeScheduler.h"
#include "Synth/AlignedVector.h"
#include "Synth/CellOutput.h"
#include "Synth/Synthesiser.h"

#include <array>
#include <span>
#include <vector>

namespace idiophone {

/// A cell of sound: both channels, and the output of each slot.
struct StereoCell {
    alignas(64) std::array<float, cellSamples> left{};
    alignas(64) std::array<float, cellSamples> right{};
    AlignedVector<float> slotSamples; ///< [slots, 64] if each slot has an output of its own
    std::vector<CellOutput> slots;

    CellOutput mixed() { return {left, right}; }
};

/// `layOut` allocates. The rest is for the audio thread and neither allocates, locks nor throws.
class CellStrategy {
public:
    virtual ~CellStrategy() = default;

    /// Gives a cell the outputs of its slots.
    virtual void layOut(StereoCell& cell, std::size_t slotCount) const = 0;
    /// Overwrites the outputs with the sound of ringing modes.
    virtual void begin(Synthesiser& synthesiser, StereoCell& cell) = 0;
    /// Completes the newest cell, after ringing and held sounds.
    virtual void finish(const BegunCell& begun, StrikeScheduler& strikes, StereoCell& cell) = 0;
    /// Fades the strategy's own forces out over a cell.
    virtual void fadeForces(Synthesiser& synthesiser, StereoCell& cell) = 0;
    /// Returns whether notes strike or press with mallets, and dampers follow keys.
    virtual bool hasMallets() const = 0;
    /// Starts a note's bodies, at a sample of a cell.
    virtual void startNote(int note, int velocity, std::int64_t cell, int sampleInCell) = 0;
};

/// All slots share one output, and strikes act within a cell.
class MalletCells final : public CellStrategy {
public:
    void layOut(StereoCell& cell, std::size_t slotCount) const override {
        cell.slots.assign(slotCount, cell.mixed());
    }
    void begin(Synthesiser& synthesiser, StereoCell& cell) override {
        synthesiser.beginCell(cell.mixed());
    }
    void finish(const BegunCell&, StrikeScheduler&, StereoCell&) override {}
    void fadeForces(Synthesiser&, StereoCell&) override {}
    bool hasMallets() const override { return true; }
    void startNote(int, int, std::int64_t, int) override {}
};

/// Each slot has its own output, which the listener's ears mix. The ears process whole cells, so
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
    void startNote(int note, int velocity, std::int64_t cell, int sampleInCell) override {
        performance.startNote(note, velocity, cell, sampleInCell);
    }

private:
    StagePlayer& performance;
};

} // namespace idiophone
