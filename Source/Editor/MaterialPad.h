// The map of materials: a dot for each named one, a ring at the current sound. A click on a dot
// selects that material; dragging elsewhere mixes live.
#pragma once

#include "Editor/Appearance.h"
#include "Editor/ControlHost.h"
#include "Editor/DescribedComponent.h"
#include "Editor/GestureBurst.h"
#include "Editor/Look.h"
#include "Editor/MaterialInEffect.h"
#include "Editor/MaterialPlane.h"
#include "Editor/ProcessorView.h"
#include "Editor/Utf8.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace idiophone {

/// The figures of the custom material, then the choice that selects it.
inline constexpr std::array customMaterialParameters{
    ParameterId::youngsModulus,       ParameterId::density,    ParameterId::fluidDamping,
    ParameterId::viscoelasticDamping, ParameterId::lossFactor, ParameterId::material};

class MaterialPad final : public DescribedComponent {
public:
    explicit MaterialPad(ProcessorView& processor)
        : DescribedComponent(juce::AccessibilityRole::slider), view(processor),
          burst([this] { beginEdit(); }, [this] { endEdit(); }) {
        setTitle("Material pad");
        setDescription(
            "From slow to fast sound, from dull to ringing; arrows move between materials");
        setTooltip("Click a dot to take that material, drag between them to mix");
        setWantsKeyboardFocus(true);
        refresh();
    }

    /// Moves the ring if the material has changed.
    void refresh() {
        const auto now = placeOf(figuresInEffect(view));
        const auto displayNow = valueDisplayAround(*this);
        if (now.fast == shown.fast && now.ringing == shown.ringing && displayNow == display)
            return;
        shown = now;
        display = displayNow;
        notifyDescriptionChanged();
        repaint();
    }

    void paint(juce::Graphics& g) override {
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
    void mouseDown(const juce::MouseEvent& event) override {
        burst.finish();
        if (!event.mods.isLeftButtonDown())
            return;
        beginEdit();
        if (const auto named = namedAt(event.position))
            choose(*named);
        else
            mix(placeAt(event.position));
    }
    void mouseDrag(const juce::MouseEvent& event) override {
        if (editing && (mixing || static_cast<float>(event.getDistanceFromDragStart()) >= reach))
            mix(placeAt(event.position));
    }
    void mouseUp(const juce::MouseEvent&) override {
        if (editing)
            endEdit();
    }
    void mouseMove(const juce::MouseEvent& event) override { hover(namedAt(event.position)); }
    void mouseExit(const juce::MouseEvent&) override { hover(std::nullopt); }
    bool keyPressed(const juce::KeyPress& key) override {
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
    void focusGained(FocusChangeType) override { repaint(); }
    void focusLost(FocusChangeType) override {
        burst.finish();
        repaint();
    }
    juce::String description() const override {
        const double seconds = decaySecondsAt(shown);
        const auto rings = "rings " + juce::String(seconds, seconds < 1 ? 2 : 1) + " s";
        return display == ValueDisplay::plain
                   ? rings
                   : juce::String(juce::roundToInt(soundMetresPerSecond(shown))) + " m/s, " +
                         rings + " at 1 kHz";
    }

private:
    static constexpr float dotRadius = 4.5f, reach = 8;
    static constexpr int legendHeight = 16;

    juce::Rectangle<float> map() const {
        return getLocalBounds().withTrimmedBottom(legendHeight).toFloat().reduced(8);
    }
    juce::Point<float> seenAt(const PlanePlace& place) const {
        const auto area = map();
        return {area.getX() + area.getWidth() * static_cast<float>(place.fast),
                area.getBottom() - area.getHeight() * static_cast<float>(place.ringing)};
    }
    PlanePlace placeAt(juce::Point<float> position) const {
        const auto area = map();
        const auto share = [](float part, float whole) {
            return std::clamp(static_cast<double>(part / std::max(whole, 1.0f)), 0.0, 1.0);
        };
        return {.fast = share(position.x - area.getX(), area.getWidth()),
                .ringing = share(area.getBottom() - position.y, area.getHeight())};
    }
    std::optional<std::size_t> namedAt(juce::Point<float> position) const {
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
    void choose(std::size_t named) {
        view.parameters.changeOnce(ParameterId::material,
                                   double(firstLibraryMaterial) + double(named));
        refresh();
    }
    /// A press, or presses of arrow keys: one step, whether it chooses, mixes or both.
    void beginEdit() {
        editing = true;
        view.history.beginEdit("Material");
    }
    void endEdit() {
        if (std::exchange(mixing, false))
            for (const auto parameter : customMaterialParameters)
                view.parameters.endChange(parameter);
        view.history.endEdit();
        editing = false;
    }
    void mix(const PlanePlace& place) {
        if (!std::exchange(mixing, true))
            for (const auto parameter : customMaterialParameters)
                view.parameters.beginChange(parameter);
        const auto material = materialAt(place, materialLibrary());
        view.parameters.change(ParameterId::youngsModulus, material.youngsModulusPa * 1e-9);
        view.parameters.change(ParameterId::density, material.densityKgPerM3);
        view.parameters.change(ParameterId::fluidDamping, material.damping.fluidPerSecond);
        view.parameters.change(ParameterId::viscoelasticDamping,
                               material.damping.viscoelasticSeconds * 1e6);
        view.parameters.change(ParameterId::lossFactor, material.damping.lossFactor);
        view.parameters.change(ParameterId::material, customMaterial); // after its figures
        refresh();
    }
    void paintNamed(juce::Graphics& g) const {
        const auto library = materialLibrary();
        const auto area = map();
        std::vector<juce::Rectangle<float>> taken;
        for (const auto& material : library)
            taken.push_back(juce::Rectangle<float>(2 * dotRadius, 2 * dotRadius)
                                .withCentre(seenAt(placeOf(material))));
        const auto font = Look::textFont(11);
        for (std::size_t i = 0; i < library.size(); ++i) {
            const auto [red, green, blue] = appearanceOf(library[i]).colour;
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
    void hover(std::optional<std::size_t> named) {
        if (named == hovered)
            return;
        hovered = named;
        repaint();
    }

    ProcessorView& view;
    PlanePlace shown{-1, -1};
    std::optional<std::size_t> hovered; ///< index into the material library
    ValueDisplay display = ValueDisplay::plain;
    bool editing = false, mixing = false; ///< mixing: the figures' gestures are open
    GestureBurst burst;                   ///< joins presses of arrow keys into one gesture
};

} // namespace idiophone
