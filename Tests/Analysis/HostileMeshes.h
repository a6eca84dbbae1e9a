// Meshes as nobody should make them and somebody will: for tests that no mesh can take the program
// down. The same seed gives the same mesh.
#pragma once

#include "Geometry/Mesh.h"

#include <cstdint>
#include <string>

namespace idiophone::test {

struct HostileMesh {
    std::string name; ///< what it is and what was done to it
    Mesh mesh;        ///< some decimetres large, but for those whose size is the matter
};

/// Families and spoilings are drawn by the seed. Indices are valid; coordinates may be anything.
HostileMesh hostileMesh(std::uint32_t seed);

} // namespace idiophone::test
