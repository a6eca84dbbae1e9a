// What the fuzz targets share: each defines `examine`, and states claims about what came of the
// bytes. A claim that does not hold ends the process, and libFuzzer keeps the input.
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

/// The target: reads the bytes as a file's or a host's and states its claims.
void examine(std::string_view bytes);

/// Says the claim and ends the process unless it holds.
void claim(bool holds, std::string_view text);

/// The error is one sentence for people: UTF-8 of one line, neither empty nor endless.
void claimSentence(const Error& error);

template <class Values>
void claimFinite(const Values& values, std::string_view text) {
    claim(std::ranges::all_of(values, [](auto value) { return std::isfinite(value); }), text);
}

inline std::span<const std::byte> asBytes(std::string_view bytes) {
    return std::as_bytes(std::span(bytes));
}

/// A file of that name, which holds the bytes until the next one of that name is made, for what
/// reads from disk alone. In memory where the system has a place for that.
std::filesystem::path scratchFile(std::string_view bytes, const std::string& name);

} // namespace idiophone::fuzz
