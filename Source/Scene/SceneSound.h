// What a scene's bodies do to each other, as sound: blows at their samples, slides and rolls as
// continuous forces, on the synthesiser's grid.
#pragma once

#include "Scene/SceneMotion.h"
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
    void beginCell(const CellOutput& cell);
    /// A blow within it. False where too many contacts are under way on its slot.
    bool strike(const SceneBlow& blow, const CellOutput& cell);
    /// What slides and rolls until its end.
    void touch(std::span<const TouchState, TouchTracker::voiceCount> states,
               const CellOutput& cell);

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
        bool sounds = false;
    };

    bool press(Voice& voice, const TouchState& state, std::span<float, cellSamples> newtons);

    Synthesiser synth;
    double cellSeconds;
    double startSeconds;
    std::int64_t cellsBegun = 0;
    std::vector<std::size_t> surfaceOfRole;
    std::array<Voice, TouchTracker::voiceCount> voices;
};

} // namespace idiophone
