// Counts of sounding modes, and of silent ones by reason.
#pragma once

#include "Editor/DescribedComponent.h"
#include "Editor/Look.h"
#include "Editor/SoundView.h"

#include <array>
#include <utility>

namespace idiophone {

class ModeCounts final : public DescribedComponent {
public:
    ModeCounts() : DescribedComponent(juce::AccessibilityRole::staticText) { setTitle("Modes"); }

    void show(const SoundFrame& frame) {
        const std::array now{frame.modesMixed, frame.modesDropped, frame.modesMerged,
                             frame.modesBeyond};
        if (std::exchange(modes, now) != now)
            repaint();
    }

    juce::String description() const override {
        juce::StringArray parts;
        for (std::size_t k = 0; k < modes.size(); ++k)
            parts.add(juce::String(modes[k]) + " " + names[k]);
        return parts.joinIntoString(", ");
    }

    void paint(juce::Graphics& g) override {
        auto area = getLocalBounds().reduced(0, 6);
        const int width = area.getWidth() / static_cast<int>(modes.size());
        for (std::size_t k = 0; k < modes.size(); ++k) {
            auto tile = area.removeFromLeft(width).reduced(2, 0);
            g.setColour(colourOf(*this, LookColour::background));
            g.fillRoundedRectangle(tile.toFloat(), 5);
            g.setColour(colourOf(*this, LookColour::text));
            g.setFont(Look::headingFont(16));
            g.drawText(juce::String(modes[k]), tile.removeFromTop(21).translated(0, 2),
                       juce::Justification::centred, false);
            g.setColour(colourOf(*this, LookColour::dimText));
            g.setFont(Look::textFont(11.5f));
            g.drawText(names[k], tile, juce::Justification::centred, false);
        }
    }

private:
    static constexpr std::array names{"sounding", "dropped", "merged", "over budget"};
    std::array<std::int32_t, names.size()> modes{};
};

} // namespace idiophone
