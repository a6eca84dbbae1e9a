// The support of a single object: a stand for a bell, a ring for a bowl, pegs for a sheet, legs for
// a table, a post at a clamp. Also draws the pips of a die.
#pragma once

#include "Editor/FurnitureParts.h"

#include <span>

namespace idiophone {

/// Adds the stand of an object with vertices. `finish` is of its own material. `clamp` is the box
/// of what is held, or empty. Returns the height of the floor.
float addStand(FurnitureParts& parts,
               const SceneObject& object,
               std::span<const SceneVertex> vertices,
               Finish finish,
               const Eigen::AlignedBox3f& clamp = {});

/// Whether an object on a stage is a flat board with the size of a table's.
bool isTableTop(const SceneObject& object);
/// Adds four legs as one part. Returns the height of their feet.
float addLegs(FurnitureParts& parts, const SceneObject& top);

/// Whether an object is a cube.
bool isDie(const SceneObject& object);
/// Adds the pips of a cube as one part. Opposite sides add up to seven.
void addPips(FurnitureParts& parts, const SceneObject& die);

} // namespace idiophone
