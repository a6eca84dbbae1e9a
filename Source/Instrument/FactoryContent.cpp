#include "Instrument/FactoryContent.h"

#include "Object/EmbeddedFiles.h"

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

Preset initialPreset() {
    Preset preset;
    preset.name = "Init";
    preset.description = "Rosewood bars with all parameters at their defaults, to start from.";
    preset.keyMap = {.kind = KeyMapKind::bars,
                     .lowestNote = 65,
                     .highestNote = 108,
                     .object = "xylophone-{note}"};
    preset.parameters.set(ParameterId::level, -8.7);
    return preset;
}

std::optional<std::span<const std::byte>> factoryObject(std::string_view name) {
    const auto files = factoryFiles();
    const auto found = std::ranges::find(files, std::string(name) + ".modal", &EmbeddedFile::name);
    if (found == files.end())
        return std::nullopt;
    return std::as_bytes(std::span(found->bytes));
}

} // namespace idiophone
