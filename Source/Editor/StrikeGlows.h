// The light of sounding objects: it spreads from the struck place and fades with the sound.
#pragma once

#include "Editor/SceneFrame.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace idiophone {

/// For the message thread. Objects are indices into the scene's.
class StrikeGlows {
public:
    /// Starts with dark objects of these radii in metres. The light of `wholeObjects` is even, for
    /// bodies that share an object.
    void reset(std::vector<float> objectRadii, bool wholeObjects) {
        radii = std::move(objectRadii);
        evenly = wholeObjects;
        lights.assign(radii.size(), {});
    }
    void strike(std::size_t object, const ScenePlace& place) {
        if (object < lights.size())
            lights[object] = {place, 0, lights[object].loudness};
    }
    /// Takes the loudness of each object, 0 to 1. Returns whether it has changed.
    bool follow(std::span<const float> loudness) {
        bool changed = false;
        for (std::size_t i = 0; i < std::min(loudness.size(), lights.size()); ++i) {
            changed |= lights[i].loudness != loudness[i];
            lights[i].loudness = loudness[i];
        }
        return changed;
    }
    void advance(double seconds) {
        for (auto& light : lights)
            light.age = std::min(light.age + seconds, settledSeconds);
    }
    /// Whether a light still spreads.
    bool moves() const {
        return std::ranges::any_of(lights,
                                   [](const auto& light) { return light.age < settledSeconds; });
    }
    bool sounds() const {
        return std::ranges::any_of(lights, [](const auto& light) { return light.loudness > 0; });
    }
    std::vector<ObjectGlow> glows() const {
        std::vector<ObjectGlow> result;
        for (std::size_t i = 0; i < lights.size(); ++i)
            result.push_back(glowOf(lights[i], radii[i]));
        return result;
    }

private:
    static constexpr double settledSeconds = 2;
    struct Light {
        ScenePlace place{};
        double age = settledSeconds; ///< seconds since the strike
        float loudness = 0;
    };

    ObjectGlow glowOf(const Light& light, float radius) const {
        constexpr double spreadSeconds = 0.3, flashSeconds = 0.12;
        constexpr float first = 0.14f, last = 2.2f, everywhere = 1e6f; // of the object's radius
        const auto spread = static_cast<float>(1 - std::exp(-light.age / spreadSeconds));
        const auto flash = static_cast<float>(std::exp(-light.age / flashSeconds));
        const float lasting = light.loudness * (1 - 0.5f * spread);
        return {.place = light.place,
                .metres = radius * (evenly ? everywhere : first + (last - first) * spread),
                .brightness = std::max(lasting, light.age < settledSeconds ? flash : 0.0f)};
    }

    std::vector<float> radii;
    std::vector<Light> lights;
    bool evenly = false;
};

} // namespace idiophone
