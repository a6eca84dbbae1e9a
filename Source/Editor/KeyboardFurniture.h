// The frames of instruments with a keyboard: rails, cords, posts and tubes under bars, the rack of
// chimes, and the board of tines.
#pragma once

#include "Editor/FurnitureParts.h"

#include <span>

namespace idiophone {

/// A bar along y, or a chime along z; lengths in metres.
struct KeyboardBar {
    Eigen::Vector3f middle, half;         ///< half the extent
    float tubeRadius = 0, tubeMetres = 0; ///< of the tube below; no length: no tube
    bool isBehind = false;                ///< in the row of accidentals
    Finish finish = Finish::wood;         ///< of the bar's own material
};

/// Adds the frame of at least one bar, in the order of keys. Returns the height of the floor.
float addKeyboardFrame(FurnitureParts& parts, std::span<const KeyboardBar> bars);

/// Adds the rack of at least one chime. Returns the height of the floor.
float addChimeFrame(FurnitureParts& parts, std::span<const KeyboardBar> chimes);

/// Adds the board under at least one tine, and the block that holds the far ends. Returns the
/// height of the floor.
float addTineBoard(FurnitureParts& parts, std::span<const KeyboardBar> tines);

} // namespace idiophone
