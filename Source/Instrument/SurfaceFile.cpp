#include "Instrument/SurfaceFile.h"

#include "Object/OneLine.h"
#include "Object/UntrustedJson.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace idiophone {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

struct Figure {
    const char* key;
    double Surface::*member;
    bool required;
};

constexpr const char* slowestSpeedKey = "slowest_speed_m_per_s";
constexpr double usualSlowestRatio = 0.1;

constexpr Figure figures[] = {
    {"spectrum_exponent", &Surface::spectrumExponent, true},
    {"reson_frequency_hz", &Surface::resonFrequencyHz, true},
    {"reson_damping_per_s", &Surface::resonDampingPerSecond, true},
    {"reference_speed_m_per_s", &Surface::referenceSpeedMetresPerSecond, true},
    {slowestSpeedKey, &Surface::slowestSpeedMetresPerSecond, false},
    {"roughness", &Surface::roughness, false},
};

/// Returns the first fault of format, version and name; empty if there is none.
std::string faultOfHead(const json& root) {
    if (!root.is_object() || !root.contains("format") || root["format"] != "idiophone-surface")
        return "it is not an Idiophone surface";
    if (!root.contains("version") || !root["version"].is_number_integer() || root["version"] < 1)
        return "its version is not a whole number from 1 on";
    if (root["version"] > surfaceFormatVersion)
        return "it was made by a newer Idiophone (surface version " + root["version"].dump() + ")";
    if (root.contains("name") && !root["name"].is_string())
        return "'name' is not a text";
    return {};
}

/// Reads the figures into `surface`. Returns the first fault; empty if there is none.
std::string parseFigures(const json& root, Surface& surface) {
    for (const auto& [key, value] : root.items()) {
        const auto* figure = std::ranges::find(figures, key, &Figure::key);
        if (figure != std::end(figures) && !value.is_number())
            return "'" + key + "' is not a number";
        if (figure != std::end(figures))
            surface.*figure->member = value;
        else if (key != "format" && key != "version" && key != "name")
            return "a surface has no " + inQuotes(key);
    }
    for (const auto& figure : figures)
        if (figure.required && !root.contains(figure.key))
            return "it lacks '" + std::string(figure.key) + "'";
    return {};
}

} // namespace

Result<Surface> parseSurface(std::string_view text, std::string_view file) {
    const auto refuse = [&](const std::string& sentence) {
        return failure(std::string(file) + ": " + sentence);
    };
    if (text.size() > 1 << 16)
        return refuse("it is too large for a surface");
    const auto root = parseUntrusted(text);
    if (root.is_discarded())
        return refuse("it is not JSON" + placeOfJsonFault(text));
    if (const auto fault = faultOfHead(root); !fault.empty())
        return refuse(fault);
    Surface surface;
    surface.name = root.value("name", "");
    if (const auto fault = parseFigures(root, surface); !fault.empty())
        return refuse(fault);
    if (!root.contains(slowestSpeedKey))
        surface.slowestSpeedMetresPerSecond =
            usualSlowestRatio * surface.referenceSpeedMetresPerSecond;
    auto checked = validated(std::move(surface));
    if (!checked)
        return refuse(checked.error().message);
    return checked;
}

std::string encodeSurface(const Surface& surface) {
    ordered_json root{
        {"format", "idiophone-surface"}, {"version", surfaceFormatVersion}, {"name", surface.name}};
    for (const auto& figure : figures)
        root[figure.key] = surface.*figure.member;
    // Names come from people and files: replace bytes that are not UTF-8 rather than throw.
    return root.dump(4, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

} // namespace idiophone
