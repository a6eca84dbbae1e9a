// What a scene's bodies do to each other, as sound: blows at their samples, slides and rolls as
// continuous forces, on the synthesiser's grid.
#pragma once

#include "Scene/HeadModel.h"
#include "Scene/PlacedSource.h"
#include "Scene/SceneRun.h"
#include "Synth/AlignedVector.h"
#include "Synth/ContactForce.h"
#include "Synth/Synthesiser.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace idiophone {

/// Constructed and destroyed off the audio thread; every other member neither allocates, locks nor
/// throws.
class SceneSound {
public:
    SceneSound(const SceneCast& cast,
               std::vector<SynthesiserSlot> slots,
               double sampleRateHz,
               std::uint64_t seed = 1);

    void setSettings(const SynthesisSettings& settings) { synth.setSettings(settings); }

    /// Begins the next cell, with what rings.
    void beginCell() noexcept;
    /// A blow within it. False where too many contacts are under way on its slot.
    bool strike(const SceneBlow& blow) noexcept;
    /// What slides and rolls until its end.
    void touch(std::span<const TouchState, TouchTracker::voiceCount> states) noexcept;
    /// What the listener hears of it, with each slot at its place in metres by then.
    void finishCell(std::span<const Eigen::Vector3d> places, const CellOutput& ears) noexcept;

    double cellStartSeconds() const { return startSeconds; }
    double cellEndSeconds() const { return startSeconds + cellSeconds; }
    double nextCellEndSeconds() const { return startSeconds + 2 * cellSeconds; }
    bool silent() const;
    const Synthesiser& synthesiser() const { return synth; }

private:
    struct Voice {
        std::vector<ContactForce> slides, rolls; ///< one for each surface
        TouchState last;
        std::size_t surface = 0;
    };

    bool
    press(Voice& voice, const TouchState& state, std::span<float, cellSamples> newtons) noexcept;

    Synthesiser synth;
    HeadModel head;
    AlignedVector<float> samples;      ///< [slots, 64]
    std::vector<CellOutput> cells;     ///< in them
    std::vector<PlacedSource> sources; ///< of the slots
    double cellSeconds;
    double startSeconds;
    std::int64_t cellsBegun = 0;
    std::vector<std::size_t> surfaceOfRole;
    std::array<Voice, TouchTracker::voiceCount> voices;
};

} // namespace idiophone
