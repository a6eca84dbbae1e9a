// States the claims about a mesh file, for the targets of all formats.
#pragma once

#include "Fuzz/FuzzTarget.h"

namespace idiophone::fuzz {

/// Reads the bytes as a mesh file with that extension (".obj").
void examineMesh(std::string_view bytes, const std::string& extension);

} // namespace idiophone::fuzz
