#include "Editor/HoverOutline.h"

#include "Editor/Look.h"
#include "Editor/ModeText.h"
#include "Editor/PixelProjection.h"
#include "Geometry/ConvexHull.h"

#include <algorithm>
#include <vector>

namespace idiophone {

bool HoverOutline::show(std::optional<Hover> next) {
    if (!next)
        outlined.reset();
    return std::exchange(shown, next) != shown;
}

juce::String HoverOutline::textOf(const Hover& hover) {
    const auto velocity = "velocity " + juce::String(hover.velocity);
    return hover.note < 0 ? velocity : noteName(hover.note) + ", " + velocity;
}

void HoverOutline::paint(juce::Graphics& g,
                         const juce::Component& component,
                         const ObjectScene& scene,
                         const OrbitCamera& camera) {
    if (!shown || shown->object >= scene.objects().size())
        return;
    const auto area = component.getLocalBounds().toFloat();
    const float aspect = area.getWidth() / std::max(area.getHeight(), 1.0f);
    // A large object takes some milliseconds, and only its text changes while the mouse moves.
    if (const View now{shown->object, shown->body, camera.viewProjection(aspect), area};
        outlined != now) {
        outline = outlineOf(scene, now);
        outlined = now;
    }
    if (outline.isEmpty())
        return;
    g.setColour(colourOf(component, LookColour::accent));
    g.strokePath(outline, juce::PathStrokeType(1.6f, juce::PathStrokeType::curved));
    paintText(g, component, outline.getBounds());
}

juce::Path HoverOutline::outlineOf(const ObjectScene& scene, const View& view) {
    const PixelProjection projection(view.viewProjection, view.area);
    const auto& object = scene.objects()[view.object];
    const auto pose = view.body ? poseOf(*view.body) : Eigen::Isometry3f::Identity();
    std::vector<Eigen::Vector2f> points;
    for (const auto& vertex : scene.vertices().subspan(object.firstVertex, object.vertexCount))
        if (const auto pixel = projection.pixelOf(pose * vectorOf(vertex.place)))
            points.emplace_back(pixel->x, pixel->y);
    const auto hull = convexHull(points);
    juce::Path path;
    if (hull.size() < 3)
        return path;
    path.startNewSubPath(hull.front().x(), hull.front().y());
    for (const auto& corner : hull)
        path.lineTo(corner.x(), corner.y());
    path.closeSubPath();
    return path;
}

void HoverOutline::paintText(juce::Graphics& g,
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

} // namespace idiophone
