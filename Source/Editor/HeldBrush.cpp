#include "Editor/HeldBrush.h"

#include "Editor/Look.h"
#include "Editor/SeenPlaces.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {
namespace {

using Eigen::Vector3d;

constexpr std::size_t maximumVertices = 500; // drawn; each takes a ray to see whether it is hidden
constexpr double radius = HeldSettings::placeRadius;

std::vector<ScenePlace> heldVertices(const ShownInstrument& shown) {
    const auto& played = shown.played;
    std::size_t count = 0;
    for (const auto& one : played)
        count += one.object->clampedVertices.size();
    const std::size_t step = count / maximumVertices + 1;
    std::vector<ScenePlace> places;
    for (std::size_t i = 0; i < played.size(); ++i) {
        const auto& object = *played[i].object;
        for (std::size_t k = 0; k < object.clampedVertices.size(); k += step) {
            const auto at = 3 * static_cast<std::size_t>(object.clampedVertices[k]);
            places.push_back(shown.scene->placeOf(i, {double(object.vertices[at]),
                                                      double(object.vertices[at + 1]),
                                                      double(object.vertices[at + 2])}));
        }
    }
    return places;
}

} // namespace

void HeldBrush::show(const ProcessorView& view, const ShownInstrument& shown) {
    vertices.clear();
    if (!shown.onStage)
        vertices = heldVertices(shown);
    wallMetres = 0;
    for (const auto& [object, sizeRatio, lowest, highest] : shown.played)
        if (!object->clampedVertices.empty())
            wallMetres =
                std::max(wallMetres, static_cast<float>(sizeRatio * object->thicknessMetres));
    longestMetres = 0;
    if (shown.onStage || shown.played.size() != 1 || shown.scene->empty()) {
        drawing = false;
        places.clear();
        return;
    }
    const auto& one = shown.played.front();
    Eigen::AlignedBox3d box;
    for (std::size_t i = 0; i + 2 < one.object->vertices.size(); i += 3)
        box.extend(Eigen::Vector3f(&one.object->vertices[i]).cast<double>());
    corner = box.min();
    longestMetres = box.sizes().maxCoeff();
    sceneScale = one.sizeRatio;
    if (!drawing) {
        places.clear();
        const auto held = view.workshop.importStatus().settings.held;
        if (held.kind == HeldSettings::Kind::places)
            for (const auto& place : held.places)
                places.emplace_back(place.data());
    }
}

/// Places lie half a radius apart.
void HeldBrush::touch(const Vector3d& place, bool frees) {
    if (frees)
        std::erase_if(places,
                      [&](const Vector3d& known) { return (known - place).norm() < radius; });
    else if (places.size() < HeldSettings::maximumPlaces &&
             std::ranges::none_of(places, [&](const Vector3d& known) {
                 return (known - place).norm() < radius / 2;
             }))
        places.push_back(place);
}

void HeldBrush::drawTo(const ScenePick& pick, bool frees) {
    constexpr double farthestStep = 6 * radius; // the mouse has left the object in between
    if (!(longestMetres > 0))
        return;
    const Vector3d place = (Vector3d(pick.pointMetres.data()) - corner) / longestMetres;
    const Vector3d from = drawing && (place - last).norm() < farthestStep ? last : place;
    const double steps = std::ceil(1 + 2 * (place - from).norm() / radius);
    for (double step = 1; step <= steps; ++step)
        touch(from + (place - from) * (step / steps), frees);
    last = place;
    drawing = true;
}

void HeldBrush::finishDrawing(ProcessorView& view) {
    const auto status = view.workshop.importStatus();
    auto settings = status.settings;
    // Another sound may have been loaded meanwhile.
    if (!std::exchange(drawing, false) || settings.held.kind != HeldSettings::Kind::places)
        return;
    settings.held.places.clear();
    for (const auto& place : places)
        settings.held.places.push_back({place.x(), place.y(), place.z()});
    view.workshop.setImportSettings(settings);
    if (!status.followsSettings)
        view.workshop.analyseAgain();
}

void HeldBrush::paint(juce::Graphics& g,
                      const juce::Component& component,
                      const ObjectScene& scene,
                      const OrbitCamera& camera) const {
    constexpr float dot = 5, brushAlpha = 0.45f;
    const SeenPlaces seenPlaces(scene, camera, component.getLocalBounds().toFloat());
    const auto colour = colourOf(component, LookColour::held);
    for (const auto& seen : seenPlaces.of(vertices, wallMetres)) {
        g.setColour(seen.in(colour));
        g.fillEllipse(juce::Rectangle<float>(dot, dot).withCentre(seen.at));
    }
    std::vector<ScenePlace> painted;
    for (const auto& place : places) {
        const Vector3d metres = corner + longestMetres * place;
        painted.push_back(scene.placeOf(0, {metres.x(), metres.y(), metres.z()}));
    }
    if (painted.empty())
        return;
    const float pixels = seenPlaces.pixelsOfBall(
        painted.front(), static_cast<float>(radius * longestMetres * sceneScale));
    juce::Path discs; // one path, so that overlaps are not darker
    for (const auto& seen : seenPlaces.of(painted))
        if (!seen.isHidden)
            discs.addEllipse(juce::Rectangle<float>(2 * pixels, 2 * pixels).withCentre(seen.at));
    g.setColour(colour.withAlpha(brushAlpha));
    g.fillPath(discs);
}

} // namespace idiophone
