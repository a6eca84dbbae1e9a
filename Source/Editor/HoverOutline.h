// The outline of the object under the mouse, with its note and the velocity of a click there.
#pragma once

#include "Editor/Look.h"
#include "Editor/ModeText.h"
#include "Editor/ObjectScene.h"
#include "Editor/OrbitCamera.h"

#include <algorithm>
#include <juce_gui_basics/juce_gui_basics.h>
#include <optional>
#include <vector>

namespace idiophone {

/// The convex outline of points in the plane, counter-clockwise (Andrew's monotone chain).
inline std::vector<juce::Point<float>> convexOutline(std::vector<juce::Point<float>> points) {
    std::ranges::sort(points, [](const auto& a, const auto& b) {
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    });
    std::vector<juce::Point<float>> outline;
    const auto addChain = [&](auto begin, auto end) {
        const auto first = outline.size();
        for (auto point = begin; point != end; ++point) {
            while (outline.size() >= first + 2) {
                const auto& last = outline.back();
                const auto side = last - outline[outline.size() - 2], next = *point - last;
                if (side.x * next.y - side.y * next.x > 0)
                    break;
                outline.pop_back();
            }
            outline.push_back(*point);
        }
        if (!outline.empty())
            outline.pop_back(); // begins the other chain
    };
    addChain(points.begin(), points.end());
    addChain(points.rbegin(), points.rend());
    return outline;
}

/// For the message thread.
class HoverOutline {
public:
    struct Hover {
        std::size_t object = 0;
        int note = -1; ///< MIDI note of the object's only key; −1: it has several
        int velocity = 0;

        bool operator==(const Hover&) const = default;
    };

    /// Returns whether the outline has changed.
    bool show(std::optional<Hover> next) { return std::exchange(shown, next) != shown; }

    /// "C5, velocity 96".
    static juce::String textOf(const Hover& hover) {
        const auto velocity = "velocity " + juce::String(hover.velocity);
        return hover.note < 0 ? velocity : noteName(hover.note) + ", " + velocity;
    }

    void paint(juce::Graphics& g,
               const juce::Component& component,
               const ObjectScene& scene,
               const OrbitCamera& camera) const {
        if (!shown || shown->object >= scene.objects().size())
            return;
        const auto area = component.getLocalBounds().toFloat();
        const float aspect = area.getWidth() / std::max(area.getHeight(), 1.0f);
        const auto& object = scene.objects()[shown->object];
        std::vector<juce::Point<float>> points;
        for (const auto& vertex :
             scene.vertices().subspan(object.firstVertex, object.vertexCount)) {
            const auto [x, y] = camera.seenAt(vertex.place, aspect);
            points.emplace_back((x + 1) / 2 * area.getWidth(), (1 - y) / 2 * area.getHeight());
        }
        const auto outline = convexOutline(std::move(points));
        if (outline.size() < 3)
            return;
        juce::Path path;
        path.startNewSubPath(outline.front());
        for (const auto& point : outline)
            path.lineTo(point);
        path.closeSubPath();
        g.setColour(colourOf(component, LookColour::accent));
        g.strokePath(path, juce::PathStrokeType(1.6f, juce::PathStrokeType::curved));
        paintText(g, component, path.getBounds());
    }

private:
    void paintText(juce::Graphics& g,
                   const juce::Component& component,
                   juce::Rectangle<float> around) const {
        const auto text = textOf(*shown);
        const auto font = Look::headingFont();
        constexpr float height = 20, padding = 8;
        const float width = juce::GlyphArrangement::getStringWidth(font, text) + 2 * padding;
        const auto label = juce::Rectangle<float>(width, height)
                               .withCentre({around.getCentreX(), around.getY() - height})
                               .constrainedWithin(component.getLocalBounds().toFloat().reduced(4));
        g.setColour(colourOf(component, LookColour::panel).withAlpha(0.88f));
        g.fillRoundedRectangle(label, 5);
        g.setColour(colourOf(component, LookColour::text));
        g.setFont(font);
        g.drawText(text, label, juce::Justification::centred, false);
    }

    std::optional<Hover> shown;
};

} // namespace idiophone
