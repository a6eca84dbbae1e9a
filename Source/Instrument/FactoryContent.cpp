#include "Instrument/FactoryContent.h"

#include "FactoryFiles.h"
#include "Instrument/EmbeddedFiles.h"

#include <string>

namespace idiophone {
namespace {

std::span<const EmbeddedFile> files() {
    static const auto all = embeddedFiles({.count = FactoryFiles::namedResourceListSize,
                                           .resources = FactoryFiles::namedResourceList,
                                           .fileNames = FactoryFiles::originalFilenames,
                                           .bytesOf = FactoryFiles::getNamedResource});
    return all;
}

} // namespace

std::span<const Preset> factoryPresets() {
    static const auto presets = parseEmbedded<Preset>(files(), parsePreset);
    return presets;
}

const Preset* findFactoryPreset(std::string_view name) {
    return findNamed(factoryPresets(), name);
}

std::optional<std::span<const std::byte>> factoryObject(std::string_view name) {
    const auto found =
        std::ranges::find(files(), std::string(name) + ".modal", &EmbeddedFile::name);
    if (found == files().end())
        return std::nullopt;
    return std::as_bytes(std::span(found->bytes));
}

} // namespace idiophone
