#include "Instrument/FactoryContent.h"

#include "Instrument/EmbeddedFiles.h"

#include <string>

namespace idiophone {

std::span<const EmbeddedFile> factoryFiles(); // generated

std::span<const Preset> factoryPresets() {
    static const auto presets = parseEmbedded<Preset>(factoryFiles(), parsePreset);
    return presets;
}

const Preset* findFactoryPreset(std::string_view name) {
    return findNamed(factoryPresets(), name);
}

std::optional<std::span<const std::byte>> factoryObject(std::string_view name) {
    const auto files = factoryFiles();
    const auto found = std::ranges::find(files, std::string(name) + ".modal", &EmbeddedFile::name);
    if (found == files.end())
        return std::nullopt;
    return std::as_bytes(std::span(found->bytes));
}

} // namespace idiophone
