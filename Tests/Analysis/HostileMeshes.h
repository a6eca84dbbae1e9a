// Hostile meshes for tests that no mesh can crash the program. The same seed gives the same mesh.
#pragma once

#include "Mesh/Mesh.h"

#include <cstdint>
#include <string>

namespace idiophone::test {

struct HostileMesh {
    std::string name; ///< the mesh's family and its damage
    Mesh mesh;        ///< a few decimetres, unless its size is the damage
};

/// Draws a family and the damage from the seed. Indices are valid; coordinates may be anything.
HostileMesh hostileMesh(std::uint32_t seed);

} // namespace idiophone::test
