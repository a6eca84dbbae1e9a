#include "Editor/PathOverlay.h"

#include "Editor/Look.h"
#include "Editor/ModeText.h"
#include "Editor/SeenPlaces.h"

#include <cmath>
#include <utility>

namespace idiophone {
namespace {

constexpr std::size_t maximumPathPoints = 500;

void paintLine(juce::Graphics& g,
               const std::vector<SeenPlace>& seen,
               juce::Colour colour,
               float width) {
    for (std::size_t i = 1; i < seen.size(); ++i) {
        g.setColour(seen[i].in(colour));
        g.drawLine({seen[i - 1].at, seen[i].at}, width);
    }
}

void paintEnd(juce::Graphics& g, const SeenPlace& seen, juce::Colour colour) {
    g.setColour(seen.in(colour));
    g.fillEllipse(juce::Rectangle<float>(7, 7).withCentre(seen.at));
}

void paintKey(juce::Graphics& g,
              const SeenPlace& seen,
              const juce::String& key,
              juce::Colour colour) {
    g.setColour(colour);
    g.drawText(key, juce::Rectangle<float>(60, 16).withCentre(seen.at.translated(0, -13)),
               juce::Justification::centred, false);
}

} // namespace

void PathOverlay::showStruckPlaces(const ProcessorView& view,
                                   const std::vector<InstrumentView::PlayedObject>& played,
                                   const ObjectScene& scene) {
    const bool keysLieAlongPath = view.workshop.keyLayout() == KeyLayout::zones;
    for (std::size_t i = 0; i < played.size(); ++i) {
        Path path;
        for (const auto& place : view.instrument.struckPlaces(i))
            path.places.push_back(scene.placeOf(i, place));
        if (keysLieAlongPath && played[i].highestNote > played[i].lowestNote) {
            path.lowestKey = noteName(played[i].lowestNote);
            path.highestKey = noteName(played[i].highestNote);
        }
        paths.push_back(std::move(path));
    }
}

void PathOverlay::drawTo(const ScenePick& pick) {
    if ((drawnOn && *drawnOn != pick.object) || drawn.size() >= maximumPathPoints)
        return;
    drawnOn = pick.object;
    drawn.push_back(pick.place);
    drawnMetres.push_back(pick.pointMetres);
}

void PathOverlay::finishDrawing(ProcessorView& view) {
    if (drawnOn && drawn.size() > 1)
        view.workshop.setStrikePath(*drawnOn, drawnMetres);
    drawn.clear();
    drawnMetres.clear();
    drawnOn.reset();
}

void PathOverlay::paint(juce::Graphics& g,
                        const juce::Component& component,
                        const ObjectScene& scene,
                        const OrbitCamera& camera,
                        bool showsStruckPlaces) const {
    const auto colour = colourOf(component, LookColour::accent);
    const auto textColour = colourOf(component, LookColour::text);
    const SeenPlaces seenPlaces(scene, camera, component.getLocalBounds().toFloat());
    g.setFont(Look::headingFont());
    for (const auto& [places, lowestKey, highestKey] : paths) {
        if (!showsStruckPlaces)
            continue;
        const auto seen = seenPlaces.of(places);
        if (seen.empty())
            continue;
        paintLine(g, seen, colour, 2);
        paintEnd(g, seen.front(), colour);
        paintEnd(g, seen.back(), colour);
        paintKey(g, seen.front(), lowestKey, textColour);
        paintKey(g, seen.back(), highestKey, textColour);
    }
    paintLine(g, seenPlaces.of(drawn), textColour, 3);
}

} // namespace idiophone
