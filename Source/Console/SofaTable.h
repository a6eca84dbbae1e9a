// The message from the process that reads a SOFA file: a sentence, or a head's responses.
#pragma once

#include "World/HeadResponses.h"

#include <cstdint>
#include <string_view>

namespace idiophone {

/// Larger files are refused.
inline constexpr std::uintmax_t largestSofaBytes = 1 << 28;
/// The other process ends after this much processor time.
inline constexpr int sofaPatienceSeconds = 15;

/// Decodes the output of the command `sofa-table`. The error is the sentence of that command,
/// without the file's name, or says that the output is no table.
Result<std::shared_ptr<const HeadResponses>> decodeSofaTable(std::string_view bytes);

} // namespace idiophone
