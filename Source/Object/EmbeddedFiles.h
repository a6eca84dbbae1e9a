// SPDX-License-Identifier: Apache-2.0
// Reads files that the build embeds in the program (cmake/EmbeddedFiles.cmake).
#pragma once

#include "Object/SameName.h"

#include <algorithm>
#include <cstdlib>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace idiophone {

/// Valid for the life of the program.
struct EmbeddedFile {
    std::string_view name; ///< without its folder
    std::string_view bytes;
};

/// Returns `parse(text, fileName)` of each JSON file. Ends the program if one fails: tests must
/// make sure that none does.
template <class Content, class Parse>
std::vector<Content> parseEmbedded(std::span<const EmbeddedFile> files, Parse parse) {
    std::vector<Content> contents;
    for (const auto& file : files) {
        if (!file.name.ends_with(".json"))
            continue;
        auto content = parse(file.bytes, file.name);
        if (!content)
            std::abort();
        contents.push_back(std::move(*content));
    }
    return contents;
}

/// Returns the entry of that name (case-insensitive), or nullptr.
template <class Content>
const Content* findNamed(std::span<const Content> contents, std::string_view name) {
    const auto found = std::ranges::find_if(
        contents, [&](const Content& content) { return sameName(content.name, name); });
    return found == contents.end() ? nullptr : &*found;
}

} // namespace idiophone
