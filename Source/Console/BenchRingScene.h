// A hundred metal rings that fall on a table within a second: the scene of Raghuvanshi & Lin 2006,
// Figure 8, without the rigid bodies.
#pragma once

#include "Console/BenchScene.h"
#include "Object/Result.h"
#include "Synth/ModalPole.h"

#include <vector>

namespace idiophone {

inline constexpr std::size_t ringCount = 100;
inline constexpr double ringStrikeSeconds = 1; ///< all strikes fall within

/// Slots 0 to 99 are the rings, 100 is the table.
struct RingScene {
    std::vector<SynthesiserSlot> slots = {};
    std::vector<SynthesiserSlot> undampedSlots = {}; ///< the same, ringing for ever
    std::vector<SceneStrike> strikes = {};           ///< ascending

    std::size_t ringVertices = 0;
    std::size_t tableVertices = 0;
};

/// Analyses a ring of 200 vertices and a table of about 600 to 22 kHz, in seconds, and strikes
/// every ring once and the table 20 times. The same on every machine.
Result<RingScene> makeRingScene();

/// The poles of an object's modes between 20 Hz and 0.49 of the sample rate, undamped.
std::vector<ModalPole> audiblePoles(const ModalObject& object);

/// 3N poles for an object of N vertices, as eq. 12 counts: those of `audiblePoles` over and over,
/// for what a mode costs does not depend on its frequency.
std::vector<ModalPole> polesOfEveryMode(const ModalObject& object);

} // namespace idiophone
