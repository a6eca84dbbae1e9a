// A hundred metal rings that fall on a table within a second: the scene of Raghuvanshi & Lin 2006,
// Figure 8, without the rigid bodies.
#pragma once

#include "Benchmarks/Scene.h"
#include "Object/Result.h"
#include "Synth/ModalPole.h"

#include <vector>

namespace idiophone {

inline constexpr std::size_t ringCount = 100;
inline constexpr double ringStrikeSeconds = 1; ///< all strikes occur within this time

/// Slots 0 to 99 are the rings, and 100 is the table.
struct RingScene {
    std::vector<SynthesiserSlot> slots = {};
    std::vector<SynthesiserSlot> undampedSlots = {}; ///< the same slots without damping
    std::vector<SceneStrike> strikes = {};           ///< ascending

    std::size_t ringVertices = 0;
    std::size_t tableVertices = 0;
};

/// Analyses a ring of 200 vertices and a table of about 600 up to 22 kHz, which takes seconds.
/// Strikes every ring once and the table 20 times. The result is the same on every machine.
Result<RingScene> makeRingScene();

/// Returns the undamped poles of an object's modes between 20 Hz and 0.49 of the sample rate.
std::vector<ModalPole> audiblePoles(const ModalObject& object);

/// Returns 3N poles for an object of N vertices, as eq. 12 counts. Repeats those of `audiblePoles`,
/// because the cost of a mode does not depend on its frequency.
std::vector<ModalPole> polesOfEveryMode(const ModalObject& object);

} // namespace idiophone
