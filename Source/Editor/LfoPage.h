// The page of the sources that move by themselves: two LFOs, and the envelope of each note.
#pragma once

#include "Editor/DeckPage.h"
#include "Editor/Look.h"
#include "Editor/ParameterColumns.h"

#include <array>
#include <memory>
#include <vector>

namespace idiophone {

class LfoPage final : public DeckPage {
public:
    explicit LfoPage(ProcessorView& view) : DeckPage("LFOs"), lfos(groups(), view) {
        using enum ParameterId;
        addAndMakeVisible(lfos);
        const std::array stages{envelopeAttack, envelopeDecay, envelopeSustain, envelopeRelease};
        for (std::size_t i = 0; i < stages.size(); ++i) {
            envelope[i] = std::make_unique<ParameterControl>(parameterInfo(stages[i]), view,
                                                             ParameterControl::Shape::knob);
            addAndMakeVisible(*envelope[i]);
        }
    }

    void refresh() override {
        lfos.refresh();
        for (auto& stage : envelope)
            stage->refresh();
    }

    void paint(juce::Graphics& g) override {
        g.setColour(colourOf(*this, LookColour::text));
        g.setFont(Look::headingFont());
        g.drawText("Envelope", heading, juce::Justification::centredLeft);
    }

    void resized() override {
        auto area = getLocalBounds().reduced(padding);
        auto below = area.removeFromBottom(area.getHeight() * 2 / 5);
        lfos.setBounds(area);
        heading = below.removeFromTop(headingHeight);
        const int width = below.getWidth() / static_cast<int>(envelope.size());
        for (auto& stage : envelope)
            stage->setBounds(below.removeFromLeft(width).reduced(3, 0));
    }

private:
    static constexpr int headingHeight = 18;

    static std::vector<ParameterGroup> groups() { return {{"LFO 1", 0}, {"LFO 2", 1}}; }

    ParameterColumns lfos;
    std::array<std::unique_ptr<ParameterControl>, 4> envelope;
    juce::Rectangle<int> heading;
};

} // namespace idiophone
