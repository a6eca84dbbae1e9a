// The names of the program's own materials and mallets for choice parameters. The build generates
// the source files from Resources (cmake/EmbeddedLists.cmake), so that each name is written once.
#pragma once

#include <span>
#include <string_view>

namespace idiophone {

/// Both return the names in the order of their list. The spans are always valid.
std::span<const std::string_view> embeddedMaterialsNames() noexcept;
std::span<const std::string_view> embeddedMalletsNames() noexcept;

} // namespace idiophone
