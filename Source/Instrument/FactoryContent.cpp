#include "Instrument/FactoryContent.h"

#include "FactoryFiles.h"
#include "Object/SameName.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

namespace idiophone {
namespace {

std::optional<std::string_view> embeddedFile(std::string_view fileName) {
    for (int i = 0; i < FactoryFiles::namedResourceListSize; ++i) {
        if (fileName != FactoryFiles::originalFilenames[i])
            continue;
        int size = 0;
        const char* bytes =
            FactoryFiles::getNamedResource(FactoryFiles::namedResourceList[i], size);
        return std::string_view(bytes, static_cast<std::size_t>(size));
    }
    return std::nullopt;
}

std::vector<Preset> parseAll() {
    std::vector<std::string_view> files;
    for (int i = 0; i < FactoryFiles::namedResourceListSize; ++i)
        if (std::string_view(FactoryFiles::originalFilenames[i]).ends_with(".json"))
            files.emplace_back(FactoryFiles::originalFilenames[i]);
    std::ranges::sort(files); // the files' names begin with their place in the list
    std::vector<Preset> presets;
    for (const auto file : files) {
        auto preset = parsePreset(*embeddedFile(file), file);
        // Part of the program, and every one of them is parsed by the tests.
        if (!preset)
            std::abort();
        presets.push_back(std::move(*preset));
    }
    return presets;
}

} // namespace

std::span<const Preset> factoryPresets() {
    static const auto presets = parseAll();
    return presets;
}

const Preset* findFactoryPreset(std::string_view name) {
    const auto presets = factoryPresets();
    const auto found = std::ranges::find_if(
        presets, [&](const Preset& preset) { return sameName(preset.name, name); });
    return found == presets.end() ? nullptr : &*found;
}

std::optional<std::span<const std::byte>> factoryObject(std::string_view name) {
    const auto file = embeddedFile(std::string(name) + ".modal");
    if (!file)
        return std::nullopt;
    return std::as_bytes(std::span(*file));
}

} // namespace idiophone
