// A bar chart of how the mode budget is shared among the resonators, loudest first. Each bar shows
// requested and granted modes; a line of slope S shows the entitlement.
#pragma once

#include "Editor/DescribedComponent.h"
#include "Editor/Look.h"
#include "Editor/SoundView.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace idiophone {

/// Needs at least 240 x 60 px.
class BudgetRamp final : public DescribedComponent {
public:
    BudgetRamp() : DescribedComponent(juce::AccessibilityRole::image) {
        setTitle("Shares of the budget");
        setTooltip("One bar for each sounding object, loudest first. Frame: requested modes. "
                   "Filling: granted modes. Line: modes that the slope allows.");
    }

    /// Repaints only if the picture changes.
    void show(const SoundFrame& frame) {
        std::vector<Bar> next;
        for (const SlotNow& slot : frame.slots)
            next.push_back({.asked = slot.modesRinging,
                            .share = std::max(slot.share, slot.modesMixed),
                            .entitlement = slot.entitlement});
        if (next == bars && frame.budgetModes == budgetModes && frame.modesMixed == modesMixed)
            return;
        bars = std::move(next);
        budgetModes = frame.budgetModes;
        modesMixed = frame.modesMixed;
        repaint();
    }

    juce::String description() const override {
        const juce::String budget(juce::roundToInt(budgetModes));
        if (bars.empty())
            return "Nothing sounds; the budget is " + budget + " modes";
        const bool allServed =
            std::ranges::all_of(bars, [](const Bar& bar) { return bar.share >= bar.asked; });
        return juce::String(modesMixed) + " of " + budget + " modes for " +
               juce::String(bars.size()) + (bars.size() == 1 ? " object" : " objects") +
               (allServed ? ", as many as they request" : "");
    } ///< also the caption

    void paint(juce::Graphics& g) override {
        paintAxis(g);
        if (bars.empty())
            return;
        const auto area = plot();
        const float pitch = area.getWidth() / static_cast<float>(bars.size());
        const float width = std::min(pitch * 0.8f, widestBar);
        const auto heightOf = [&](float modes) {
            return std::min(modes / highest(), 1.0f) * area.getHeight();
        };
        juce::Path line;
        for (std::size_t rank = 0; rank < bars.size(); ++rank) {
            const Bar& bar = bars[rank];
            const float centre = area.getX() + (static_cast<float>(rank) + 0.5f) * pitch;
            const auto column = [&](float height) {
                return juce::Rectangle<float>(centre - width / 2, area.getBottom() - height, width,
                                              height);
            };
            g.setColour(colourOf(*this, LookColour::accent));
            g.fillRect(column(heightOf(static_cast<float>(bar.share))));
            g.setColour(colourOf(*this, LookColour::dimText));
            g.drawRect(column(heightOf(static_cast<float>(bar.asked))), 1);
            const juce::Point at(centre, area.getBottom() - heightOf(bar.entitlement));
            if (rank == 0)
                line.startNewSubPath(bars.size() == 1 ? at.withX(area.getX()) : at);
            line.lineTo(bars.size() == 1 ? at.withX(area.getRight()) : at);
        }
        if (bars.front().entitlement > highest()) // a line far above would shrink the bars too much
            return;
        g.setColour(colourOf(*this, LookColour::text));
        g.strokePath(line, juce::PathStrokeType(1.6f));
    }

private:
    static constexpr float left = 34, captionHeight = 15, widestBar = 26;

    /// Rounds up to 1, 2 or 5 times a power of ten.
    static double roundUp(double value) {
        const double power = std::pow(10, std::floor(std::log10(std::max(value, 1.0))));
        for (const double step : {1.0, 2.0, 5.0})
            if (value <= step * power)
                return step * power;
        return 10 * power;
    }

    /// The bar of one slot, in modes.
    struct Bar {
        std::int32_t asked = 0;
        std::int32_t share = 0;
        float entitlement = 0;

        bool operator==(const Bar&) const = default;
    };

    juce::Rectangle<float> plot() const {
        return getLocalBounds()
            .toFloat()
            .withTrimmedTop(captionHeight + 8)
            .withTrimmedLeft(left)
            .withTrimmedRight(4)
            .withTrimmedBottom(captionHeight);
    }
    /// The upper end of the axis in modes. All requests fit; the entitlement line fits unless it is
    /// far above them.
    float highest() const {
        float most = 0;
        for (const Bar& bar : bars)
            most = std::max({most, static_cast<float>(bar.asked), static_cast<float>(bar.share)});
        if (!bars.empty() && bars.front().entitlement < 3 * most)
            most = std::max(most, bars.front().entitlement);
        return static_cast<float>(roundUp(std::max(most, 10.0f)));
    }
    void paintAxis(juce::Graphics& g) const {
        const auto area = plot();
        g.setFont(Look::textFont(11));
        for (const float share : {0.0f, 0.5f, 1.0f}) {
            const float y = area.getBottom() - share * area.getHeight();
            g.setColour(colourOf(*this, LookColour::outline));
            g.fillRect(area.getX(), y, area.getWidth(), 0.5f);
            g.setColour(colourOf(*this, LookColour::dimText));
            g.drawText(juce::String(share * highest()),
                       juce::Rectangle<float>(0, y - 7, left - 5, 14),
                       juce::Justification::centredRight, false);
        }
        auto bounds = getLocalBounds().toFloat();
        g.drawText("Objects, loudest first", bounds.removeFromBottom(captionHeight),
                   juce::Justification::centred, false);
        g.setColour(colourOf(*this, LookColour::text));
        g.setFont(Look::textFont(12.5f));
        g.drawText(description(), bounds.removeFromTop(captionHeight),
                   juce::Justification::centredLeft, false);
    }

    std::vector<Bar> bars;
    double budgetModes = 0;
    std::int32_t modesMixed = 0;
};

} // namespace idiophone
