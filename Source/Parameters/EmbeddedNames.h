// What choices call the program's own materials and mallets. The build makes the source files of
// Resources (cmake/EmbeddedLists.cmake), so that the names stand there alone.
#pragma once

#include <span>
#include <string_view>

namespace idiophone {

/// In the order of the list; for the life of the program.
std::span<const std::string_view> embeddedMaterialsNames() noexcept;
std::span<const std::string_view> embeddedMalletsNames() noexcept;

} // namespace idiophone
