// Renders a scene on the synthesiser's grid: impacts at their samples, sliding and rolling as
// continuous forces.
#pragma once

#include "Instrument/CellStrikes.h"
#include "Scene/SceneEars.h"
#include "Scene/SceneSimulation.h"
#include "Scene/TouchVoices.h"
#include "Synth/AlignedVector.h"
#include "Synth/Synthesiser.h"

#include <span>
#include <vector>

namespace idiophone {

/// Constructed and destroyed off the audio thread. The other members do not allocate, lock or
/// throw.
class SceneSound {
public:
    /// `head`: the listener's measured head at that sample rate; null selects a sphere.
    SceneSound(const SceneAssets& assets,
               std::vector<SynthesiserSlot> slots,
               double sampleRateHz,
               std::uint64_t seed = 1,
               const std::shared_ptr<const HeadResponses>& head = nullptr);

    void setSettings(const SynthesisSettings& settings) { synth.setSettings(settings); }

    /// Begins the next cell with the sound that is still ringing.
    void beginCell() noexcept;
    /// Adds an impact in the cell, or at once if it is earlier. Returns false if it is not valid
    /// for its slot.
    bool strike(const SceneImpact& impact) noexcept;
    /// Sets the contacts until the cell's end.
    void touch(std::span<const TouchState, TouchTracker::voiceCount> states) noexcept;
    /// Renders the cell at the listener's ears. `places` are the slots' places in metres at its
    /// end.
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
    std::vector<CellOutput> cells; ///< views into `samples`
    CellStrikes crowded;           ///< impacts on slots with no free contact
    double cellSeconds;
    double startSeconds;
    std::int64_t cellsBegun = 0;
};

} // namespace idiophone
