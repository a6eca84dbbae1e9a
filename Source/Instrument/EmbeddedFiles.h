// Reads files that juce_add_binary_data embeds in the program.
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

/// The arrays and the function of the generated header; each array has `count` entries.
struct EmbeddedSource {
    int count;
    const char* const* resources;
    const char* const* fileNames;
    const char* (*bytesOf)(const char* resource, int& size);
};

/// Returns all files in the order of their names.
inline std::vector<EmbeddedFile> embeddedFiles(const EmbeddedSource& source) {
    std::vector<EmbeddedFile> files;
    for (int i = 0; i < source.count; ++i) {
        int size = 0;
        const char* bytes = source.bytesOf(source.resources[i], size);
        files.push_back({source.fileNames[i], {bytes, static_cast<std::size_t>(size)}});
    }
    std::ranges::sort(files, {}, &EmbeddedFile::name);
    return files;
}

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
