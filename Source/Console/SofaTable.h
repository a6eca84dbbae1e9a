// What one process tells another of a SOFA file: a sentence, or a head's responses.
#pragma once

#include "Scene/HeadResponses.h"

#include <string_view>

namespace idiophone {

/// A head beyond this is not looked at.
inline constexpr std::uintmax_t largestSofaBytes = 1 << 28;
/// After so much time of its processor the other process ends itself.
inline constexpr int sofaPatienceSeconds = 15;

/// What the command `sofa-table` wrote. The error is a sentence without the file's name: what it
/// found wrong, or that this is no table.
Result<std::shared_ptr<const HeadResponses>> decodeSofaTable(std::string_view bytes);

} // namespace idiophone
