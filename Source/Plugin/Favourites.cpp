#include "Plugin/Favourites.h"

#include "Object/UntrustedJson.h"
#include "Plugin/WholeFile.h"

#include <nlohmann/json.hpp>

namespace idiophone {
namespace {

using nlohmann::json;

constexpr const char* formatName = "idiophone-favourites";
constexpr juce::int64 largestFileBytes = 1 << 20;

} // namespace

const std::set<std::string>& Favourites::read() {
    ids.clear();
    isDamaged = false;
    if (file == juce::File() || !file.existsAsFile())
        return ids;
    const auto root = file.getSize() > largestFileBytes
                          ? json(json::value_t::discarded)
                          : parseUntrusted(file.loadFileAsString().toStdString());
    isDamaged = !root.is_object() || root.value("format", json()) != formatName ||
                !root.contains("presets") || !root["presets"].is_array();
    if (!isDamaged)
        for (const auto& id : root["presets"])
            if (id.is_string())
                ids.insert(id.get<std::string>());
    return ids;
}

Result<void> Favourites::set(const std::string& id, bool favourite) {
    read();
    const bool changed = favourite ? ids.insert(id).second : ids.erase(id) > 0;
    return changed ? write() : Result<void>{};
}

Result<void> Favourites::rename(const std::string& from, const std::string& to) {
    read();
    if (ids.erase(from) == 0)
        return {};
    ids.insert(to);
    return write();
}

Result<void> Favourites::write() {
    if (file == juce::File())
        return failure("There is no place for favourites on this machine.");
    if (isDamaged)
        file.moveFileTo(file.getSiblingFile(file.getFileNameWithoutExtension() + " damaged" +
                                            file.getFileExtension())
                            .getNonexistentSibling());
    const auto text = json{{"format", formatName}, {"version", 1}, {"presets", ids}}.dump(
        4, ' ', false, json::error_handler_t::replace);
    return writeWhole(file, std::as_bytes(std::span(text)));
}

} // namespace idiophone
