// The claims about a mesh file of any format, for the targets of each.
#pragma once

#include "Fuzz/FuzzTarget.h"

namespace idiophone::fuzz {

/// The bytes as a mesh file with that extension (".obj").
void examineMesh(std::string_view bytes, const std::string& extension);

} // namespace idiophone::fuzz
