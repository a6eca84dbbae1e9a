// What a scene's bodies do to each other, as sound: blows at their samples, slides and rolls as
// continuous forces, on the synthesiser's grid.
#pragma once

#include "Instrument/CellStrikes.h"
#include "Scene/SceneEars.h"
#include "Scene/SceneRun.h"
#include "Scene/TouchVoices.h"
#include "Synth/AlignedVector.h"
#include "Synth/Synthesiser.h"

#include <span>
#include <vector>

namespace idiophone {

/// Constructed and destroyed off the audio thread; every other member neither allocates, locks nor
/// throws.
class SceneSound {
public:
    /// `head`: the listener's, measured, at that rate; none: a sphere.
    SceneSound(const SceneCast& cast,
               std::vector<SynthesiserSlot> slots,
               double sampleRateHz,
               std::uint64_t seed = 1,
               const std::shared_ptr<const HeadResponses>& head = nullptr);

    void setSettings(const SynthesisSettings& settings) { synth.setSettings(settings); }

    /// Begins the next cell, with what rings.
    void beginCell() noexcept;
    /// A blow within it, or before it: then at once. False where it is not valid for its slot.
    bool strike(const SceneBlow& blow) noexcept;
    /// What slides and rolls until its end.
    void touch(std::span<const TouchState, TouchTracker::voiceCount> states) noexcept;
    /// What the listener hears of it, with each slot at its place in metres by then.
    void finishCell(std::span<const Eigen::Vector3d> places, const CellOutput& heard) noexcept;

    double cellStartSeconds() const { return startSeconds; }
    double cellEndSeconds() const { return startSeconds + cellSeconds; }
    double nextCellEndSeconds() const { return startSeconds + 2 * cellSeconds; }
    bool silent() const { return synth.silent() && crowded.empty() && ears.silent(); }
    const Synthesiser& synthesiser() const { return synth; }

private:
    static constexpr std::size_t crowdedCapacity = 1024;

    BegunCell begunCell() noexcept { return {synth, cells, cellsBegun - 1}; }

    Synthesiser synth;
    SceneEars ears;
    TouchVoices voices;
    AlignedVector<float> samples;  ///< [slots, 64]
    std::vector<CellOutput> cells; ///< in them
    CellStrikes crowded;           ///< blows that found no room
    double cellSeconds;
    double startSeconds;
    std::int64_t cellsBegun = 0;
};

} // namespace idiophone
