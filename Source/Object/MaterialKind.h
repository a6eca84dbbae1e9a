// SPDX-License-Identifier: Apache-2.0
// The kinds of materials, by which the window draws them.
#pragma once

#include <optional>
#include <string_view>

namespace idiophone {

enum class MaterialKind { wood, metal, glass, stone, ceramic, plastic };

/// Returns the kind of that name ("wood"), or nothing.
std::optional<MaterialKind> parseMaterialKind(std::string_view text);

/// Returns the kind of a library material (case-insensitive), or nothing. Any thread.
std::optional<MaterialKind> materialKind(std::string_view name);

} // namespace idiophone
