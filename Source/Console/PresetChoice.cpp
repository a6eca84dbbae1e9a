#include "Console/PresetChoice.h"

#include "Instrument/FactoryContent.h"
#include "Instrument/PresetFile.h"
#include "Object/OneLine.h"
#include "Object/TextFile.h"

#include <iostream>
#include <utility>

namespace idiophone {

Result<Preset> findOrReadPreset(const std::string& nameOrFile) {
    if (nameOrFile.empty())
        return Preset{};
    if (const auto* preset = findFactoryPreset(nameOrFile))
        return *preset;
    std::error_code ignored;
    if (!std::filesystem::exists(nameOrFile, ignored))
        return failure(nameOrFile +
                       ": there is no such factory preset (`idiophone presets` lists them) "
                       "and no such file");
    const auto text = readTextFile(nameOrFile);
    if (!text)
        return tl::unexpected(text.error());
    auto preset = parsePreset(*text, nameOrFile);
    if (!preset)
        return preset;
    for (const auto& id : preset->unknownParameters)
        std::cerr << "warning: " << nameOrFile << ": this version does not know the parameter "
                  << inQuotes(id) << std::endl;
    preset->keyMap = withObjectsBeside(std::move(preset->keyMap), nameOrFile);
    return preset;
}

} // namespace idiophone
