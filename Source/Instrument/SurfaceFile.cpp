#include "Instrument/SurfaceFile.h"

#include "Instrument/JsonPlace.h"
#include "Object/OneLine.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

namespace idiophone {
namespace {

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

} // namespace

Surface surfaceAt(const JsonPlace& place) {
    constexpr double unbounded = std::numeric_limits<double>::infinity();
    place.expectFormat("surface", surfaceFormatVersion);
    Surface surface;
    for (const auto& [key, value] : place.members()) {
        const auto* figure = std::ranges::find(figures, key, &Figure::key);
        if (figure != std::end(figures))
            surface.*figure->member = value.number(-unbounded, unbounded);
        else if (key == "name")
            surface.name = value.textOrEmpty();
        else if (key != "format" && key != "version")
            place.fail("has no " + inQuotes(key));
    }
    for (const auto& figure : figures)
        if (figure.required)
            place.at(figure.key);
    if (!place.has(slowestSpeedKey))
        surface.slowestSpeedMetresPerSecond =
            usualSlowestRatio * surface.referenceSpeedMetresPerSecond;
    auto checked = validated(std::move(surface));
    if (!checked)
        throw JsonPlace::Fault{checked.error().message};
    return std::move(*checked);
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
