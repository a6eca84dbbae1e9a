// A graph of the velocity curve: the mallet's speed over the velocity, with a dot at the last
// strike. A drag bends the curve.
#pragma once

#include "Editor/DescribedComponent.h"
#include "Editor/Look.h"
#include "Editor/ProcessorView.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {

/// Needs 100 x 48 pixels. The slider of the parameter is the way to it without a mouse.
class VelocityGraph final : public DescribedComponent {
public:
    explicit VelocityGraph(ProcessorView& processor)
        : DescribedComponent(juce::AccessibilityRole::image), view(processor) {
        setTitle("Velocity graph");
        setTooltip("The mallet's speed from the softest to the hardest note. Drag to bend it.");
        refresh();
    }

    /// Repaints only if the curve has changed.
    void refresh() {
        const double now = view.parameters.value(ParameterId::velocityCurve);
        if (now == exponent)
            return;
        exponent = now;
        repaint();
        notifyDescriptionChanged();
    }

    /// Moves the dot to the velocity of the last strike, 1 to 127; 0 shows none.
    void showStrike(int velocity) {
        if (std::exchange(struck, velocity) != velocity)
            repaint();
    }

    juce::String description() const override {
        return "At half velocity, " + juce::String(juce::roundToInt(100 * speedAt(0.5))) +
               " % of the speed";
    }

    void paint(juce::Graphics& g) override {
        g.setColour(colourOf(*this, LookColour::background));
        g.fillRoundedRectangle(getLocalBounds().toFloat(), 5);
        const auto area = plot();
        g.setColour(colourOf(*this, LookColour::outline));
        g.drawLine({area.getBottomLeft(), area.getBottomRight()}, 1);
        g.drawLine({area.getBottomLeft(), area.getTopLeft()}, 1);
        g.setFont(Look::textFont(11));
        g.setColour(colourOf(*this, LookColour::dimText));
        g.drawText("Speed over velocity", area.reduced(5, 1), juce::Justification::topLeft, false);
        const auto placeOf = [&](float velocity) {
            return area.getRelativePoint(velocity, 1 - static_cast<float>(speedAt(velocity)));
        };
        juce::Path line;
        line.startNewSubPath(placeOf(0));
        for (float x = 1; x <= area.getWidth(); ++x)
            line.lineTo(placeOf(x / area.getWidth()));
        g.setColour(colourOf(*this, LookColour::accent));
        g.strokePath(line, juce::PathStrokeType(1.8f));
        if (struck == 0)
            return;
        g.setColour(colourOf(*this, LookColour::text));
        g.fillEllipse(juce::Rectangle<float>(8, 8).withCentre(
            placeOf(static_cast<float>(struck) / maximumVelocity)));
    }

    void mouseDown(const juce::MouseEvent& event) override {
        if (!event.mods.isLeftButtonDown())
            return;
        isDragged = true;
        view.parameters.beginChange(ParameterId::velocityCurve);
        bendTo(event.position);
    }
    void mouseDrag(const juce::MouseEvent& event) override {
        if (isDragged)
            bendTo(event.position);
    }
    void mouseUp(const juce::MouseEvent&) override {
        if (std::exchange(isDragged, false))
            view.parameters.endChange(ParameterId::velocityCurve);
    }

private:
    static constexpr float maximumVelocity = 127;

    /// Share of the full speed at a share of the full velocity.
    double speedAt(double velocity) const { return std::pow(velocity, exponent); }

    juce::Rectangle<float> plot() const { return getLocalBounds().toFloat().reduced(6); }
    /// Bends the curve through a place.
    void bendTo(juce::Point<float> place) {
        constexpr double edge = 0.02; // near the corners, every curve passes
        const auto area = plot();
        const auto share = [&](float part, float whole) {
            return std::clamp(double(part) / std::max(double(whole), 1.0), edge, 1 - edge);
        };
        view.parameters.change(ParameterId::velocityCurve,
                               std::log(share(area.getBottom() - place.y, area.getHeight())) /
                                   std::log(share(place.x - area.getX(), area.getWidth())));
        refresh();
    }

    ProcessorView& view;
    double exponent = 0; ///< as drawn
    int struck = 0;      ///< velocity of the last strike, 0: none
    bool isDragged = false;
};

} // namespace idiophone
