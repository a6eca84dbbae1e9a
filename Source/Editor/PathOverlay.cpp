#include "Editor/PathOverlay.h"

#include "Editor/Look.h"

#include <cmath>

namespace idiophone {
namespace {

constexpr float hiddenAlpha = 0.3f;

struct Seen {
    juce::Point<float> at;
    bool hidden = false;
};

bool isHidden(const ObjectScene& scene, const ScenePlace& eye, const ScenePlace& place) {
    ScenePlace direction{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        direction[axis] = place[axis] - eye[axis];
    const auto hit = scene.pick(eye, direction);
    if (!hit)
        return false;
    const auto distance = [&](const ScenePlace& to) {
        return std::hypot(to[0] - eye[0], to[1] - eye[1], to[2] - eye[2]);
    };
    return distance(hit->place) < distance(place) - 0.01f * scene.radius();
}

void paintLine(juce::Graphics& g, const std::vector<Seen>& seen, juce::Colour colour, float width) {
    for (std::size_t i = 1; i < seen.size(); ++i) {
        g.setColour(colour.withMultipliedAlpha(seen[i].hidden ? hiddenAlpha : 1.0f));
        g.drawLine({seen[i - 1].at, seen[i].at}, width);
    }
}

void paintEnd(juce::Graphics& g, const Seen& seen, juce::Colour colour) {
    g.setColour(colour.withMultipliedAlpha(seen.hidden ? hiddenAlpha : 1.0f));
    g.fillEllipse(juce::Rectangle<float>(7, 7).withCentre(seen.at));
}

void paintKey(juce::Graphics& g, const Seen& seen, const juce::String& key, juce::Colour colour) {
    g.setColour(colour);
    g.drawText(key, juce::Rectangle<float>(60, 16).withCentre(seen.at.translated(0, -13)),
               juce::Justification::centred, false);
}

} // namespace

void PathOverlay::paint(juce::Graphics& g,
                        juce::Rectangle<float> area,
                        const ObjectScene& scene,
                        const OrbitCamera& camera,
                        juce::Colour colour,
                        juce::Colour textColour) const {
    const float aspect = area.getWidth() / std::max(area.getHeight(), 1.0f);
    const auto eye = camera.eye(aspect);
    const auto allSeen = [&](const std::vector<ScenePlace>& places) {
        std::vector<Seen> seen;
        for (const auto& place : places) {
            const auto [x, y] = camera.seenAt(place, aspect);
            seen.push_back({.at = {area.getX() + (x + 1) / 2 * area.getWidth(),
                                   area.getY() + (1 - y) / 2 * area.getHeight()},
                            .hidden = isHidden(scene, eye, place)});
        }
        return seen;
    };
    g.setFont(Look::headingFont());
    for (const auto& [places, lowestKey, highestKey] : paths) {
        const auto seen = allSeen(places);
        if (seen.empty())
            continue;
        paintLine(g, seen, colour, 2);
        paintEnd(g, seen.front(), colour);
        paintEnd(g, seen.back(), colour);
        paintKey(g, seen.front(), lowestKey, textColour);
        paintKey(g, seen.back(), highestKey, textColour);
    }
    paintLine(g, allSeen(drawn), textColour, 3);
}

} // namespace idiophone
