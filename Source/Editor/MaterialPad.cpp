#include "Editor/MaterialPad.h"

#include "Editor/Look.h"
#include "Editor/MaterialColour.h"
#include "Editor/ParameterChange.h"
#include "Editor/Utf8.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace idiophone {
namespace {

using enum ParameterId;

constexpr std::array mixed{youngsModulus,       density,    fluidDamping,
                           viscoelasticDamping, lossFactor, ParameterId::material};
constexpr float dotRadius = 4.5f, reach = 8;
constexpr int legendHeight = 16;

Material materialOf(const ProcessorView& view) {
    Material now;
    now.youngsModulusPa = view.parameters.effectiveValue(youngsModulus) * 1e9;
    now.densityKgPerM3 = view.parameters.effectiveValue(density);
    now.damping = {.fluidPerSecond = view.parameters.effectiveValue(fluidDamping),
                   .viscoelasticSeconds =
                       view.parameters.effectiveValue(viscoelasticDamping) * 1e-6,
                   .lossFactor = view.parameters.effectiveValue(lossFactor)};
    return now;
}

} // namespace

MaterialPad::MaterialPad(ProcessorView& processor)
    : DescribedComponent(juce::AccessibilityRole::slider), view(processor),
      burst([this] { beginMix(); }, [this] { endMix(); }) {
    setTitle("Material pad");
    setDescription("From slow to fast sound, from dull to ringing; arrows move between materials");
    setTooltip("Click a dot to take that material, drag between them to mix");
    setWantsKeyboardFocus(true);
    refresh();
}

void MaterialPad::refresh() {
    const auto now = placeOf(materialOf(view));
    if (now.fast == shown.fast && now.ringing == shown.ringing)
        return;
    shown = now;
    notifyDescriptionChanged();
    repaint();
}

juce::Rectangle<float> MaterialPad::map() const {
    return getLocalBounds().withTrimmedBottom(legendHeight).toFloat().reduced(8);
}

juce::Point<float> MaterialPad::seenAt(const PlanePlace& place) const {
    const auto area = map();
    return {area.getX() + area.getWidth() * static_cast<float>(place.fast),
            area.getBottom() - area.getHeight() * static_cast<float>(place.ringing)};
}

PlanePlace MaterialPad::placeAt(juce::Point<float> position) const {
    const auto area = map();
    const auto share = [](float part, float whole) {
        return std::clamp(static_cast<double>(part / std::max(whole, 1.0f)), 0.0, 1.0);
    };
    return {.fast = share(position.x - area.getX(), area.getWidth()),
            .ringing = share(area.getBottom() - position.y, area.getHeight())};
}

std::optional<std::size_t> MaterialPad::namedAt(juce::Point<float> position) const {
    const auto library = materialLibrary();
    std::optional<std::size_t> nearest;
    float distance = reach;
    for (std::size_t i = 0; i < library.size(); ++i)
        if (const float away = seenAt(placeOf(library[i])).getDistanceFrom(position);
            away < distance) {
            nearest = i;
            distance = away;
        }
    return nearest;
}

void MaterialPad::choose(std::size_t named) {
    changeOnce(view, ParameterId::material, double(firstLibraryMaterial) + double(named));
    refresh();
}

void MaterialPad::beginMix() {
    mixing = true;
    for (const auto parameter : mixed)
        view.parameters.beginChange(parameter);
}

void MaterialPad::mix(const PlanePlace& place) {
    const auto material = materialAt(place, materialLibrary());
    view.parameters.change(youngsModulus, material.youngsModulusPa * 1e-9);
    view.parameters.change(density, material.densityKgPerM3);
    view.parameters.change(fluidDamping, material.damping.fluidPerSecond);
    view.parameters.change(viscoelasticDamping, material.damping.viscoelasticSeconds * 1e6);
    view.parameters.change(lossFactor, material.damping.lossFactor);
    view.parameters.change(ParameterId::material, customMaterial); // last, after all figures
    refresh();
}

void MaterialPad::endMix() {
    for (const auto parameter : mixed)
        view.parameters.endChange(parameter);
    mixing = false;
}

void MaterialPad::mouseDown(const juce::MouseEvent& event) {
    burst.finish();
    if (!event.mods.isLeftButtonDown())
        return;
    if (const auto named = namedAt(event.position))
        return choose(*named);
    beginMix();
    mix(placeAt(event.position));
}

void MaterialPad::mouseDrag(const juce::MouseEvent& event) {
    if (!event.mods.isLeftButtonDown() || (!mixing && event.getDistanceFromDragStart() < reach))
        return;
    if (!mixing)
        beginMix();
    mix(placeAt(event.position));
}

void MaterialPad::mouseUp(const juce::MouseEvent&) {
    if (mixing)
        endMix();
}

void MaterialPad::hover(std::optional<std::size_t> named) {
    if (named == hovered)
        return;
    hovered = named;
    repaint();
}

void MaterialPad::focusLost(FocusChangeType) {
    burst.finish();
    repaint();
}

bool MaterialPad::keyPressed(const juce::KeyPress& key) {
    constexpr double step = 0.02;
    auto place = shown;
    if (key == juce::KeyPress::leftKey)
        place.fast -= step;
    else if (key == juce::KeyPress::rightKey)
        place.fast += step;
    else if (key == juce::KeyPress::downKey)
        place.ringing -= step;
    else if (key == juce::KeyPress::upKey)
        place.ringing += step;
    else
        return false;
    if (isMouseButtonDown())
        return true;
    burst.extend();
    mix({std::clamp(place.fast, 0.0, 1.0), std::clamp(place.ringing, 0.0, 1.0)});
    return true;
}

juce::String MaterialPad::description() const {
    const double seconds = decaySecondsAt(shown);
    return juce::String(juce::roundToInt(soundMetresPerSecond(shown))) + " m/s, rings " +
           juce::String(seconds, seconds < 1 ? 2 : 1) + " s at 1 kHz";
}

void MaterialPad::paintNamed(juce::Graphics& g) const {
    const auto library = materialLibrary();
    const auto area = map();
    std::vector<juce::Rectangle<float>> taken;
    for (const auto& material : library)
        taken.push_back(juce::Rectangle<float>(2 * dotRadius, 2 * dotRadius)
                            .withCentre(seenAt(placeOf(material))));
    const auto font = Look::textFont(11);
    for (std::size_t i = 0; i < library.size(); ++i) {
        const auto [red, green, blue] = colourOf(library[i]);
        const auto dot = taken[i];
        g.setColour(juce::Colour::fromFloatRGBA(red, green, blue, 1));
        g.fillEllipse(dot);
        g.setColour(colourOf(*this, hovered == i ? LookColour::text : LookColour::dimText));
        g.drawEllipse(dot, hovered == i ? 1.6f : 0.6f);
        // Draw the names that fit; hovering shows the others.
        const auto name = fromUtf8(library[i].name);
        const float width = juce::GlyphArrangement::getStringWidth(font, name) + 2;
        juce::Rectangle<float> label(dot.getRight() + 2, dot.getCentreY() - 6, width, 12);
        if (label.getRight() > area.getRight() + 6)
            label.setX(dot.getX() - 2 - width);
        const bool free = std::ranges::none_of(
            taken, [&](const auto& other) { return other != dot && other.intersects(label); });
        if (free && area.expanded(6).contains(label)) {
            taken.push_back(label);
            g.setFont(font);
            g.drawText(name, label, juce::Justification::centredLeft, false);
        }
    }
}

void MaterialPad::paint(juce::Graphics& g) {
    const auto back = getLocalBounds().withTrimmedBottom(legendHeight).toFloat();
    g.setColour(colourOf(*this, LookColour::background));
    g.fillRoundedRectangle(back, 5);
    g.setColour(
        colourOf(*this, hasKeyboardFocus(false) ? LookColour::accent : LookColour::outline));
    g.drawRoundedRectangle(back.reduced(0.5f), 5, 1);
    paintNamed(g);
    const auto now = seenAt(shown);
    g.setColour(colourOf(*this, LookColour::accent));
    g.drawEllipse(juce::Rectangle<float>(15, 15).withCentre(now), 2.2f);

    auto legend = getLocalBounds().removeFromBottom(legendHeight);
    g.setFont(Look::textFont(12));
    g.setColour(colourOf(*this, LookColour::dimText));
    const auto library = materialLibrary();
    g.drawFittedText(hovered ? fromUtf8(library[*hovered].name) : description(), legend,
                     juce::Justification::centred, 1, 0.75f);
}

} // namespace idiophone
