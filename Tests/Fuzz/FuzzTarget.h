// Declares what all fuzz targets need: each defines `examine`, and states claims about the result
// of the bytes. A false claim ends the process, and libFuzzer keeps the input.
#pragma once

#include "Object/Result.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace idiophone::fuzz {

/// Reads the bytes as a file or as host data, and states claims; each target defines it.
void examine(std::string_view bytes);

/// Prints the claim and ends the process unless it holds.
void claim(bool holds, std::string_view text);

/// Claims that the error is one sentence for users: one line of UTF-8, neither empty nor too long.
void claimSentence(const Error& error);

template <class Values>
void claimFinite(const Values& values, std::string_view text) {
    claim(std::ranges::all_of(values, [](auto value) { return std::isfinite(value); }), text);
}

inline std::span<const std::byte> asBytes(std::string_view bytes) {
    return std::as_bytes(std::span(bytes));
}

/// Writes the bytes to a file of that name, for readers that need a file; the next call with the
/// name overwrites it. The file is in memory if the system offers that.
std::filesystem::path scratchFile(std::string_view bytes, const std::string& name);

} // namespace idiophone::fuzz
