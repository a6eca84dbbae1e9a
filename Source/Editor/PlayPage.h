// The first page: eight large knobs for what a player changes most. They are the first parameters
// of the host.
#pragma once

#include "Editor/DeckPage.h"
#include "Editor/Look.h"
#include "Editor/ParameterControl.h"

#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

namespace idiophone {

class PlayPage final : public DeckPage {
public:
    explicit PlayPage(ProcessorView& view) : DeckPage("Play") {
        for (const auto& info : parameterTable())
            if (info.group == std::string_view("Play")) {
                knobs.push_back(
                    std::make_unique<ParameterControl>(info, view, ParameterControl::Shape::knob));
                addAndMakeVisible(*knobs.back());
            }
    }

    void refresh() override {
        for (auto& knob : knobs)
            knob->refresh();
    }

    void resized() override {
        constexpr int columns = 4;
        const auto area = getLocalBounds().reduced(padding);
        const int width = area.getWidth() / columns, height = area.getHeight() / 2;
        for (int i = 0; i < static_cast<int>(knobs.size()); ++i)
            knobs[static_cast<std::size_t>(i)]->setBounds(
                juce::Rectangle<int>(area.getX() + i % columns * width,
                                     area.getY() + i / columns * height, width, height)
                    .reduced(3));
    }

private:
    std::vector<std::unique_ptr<ParameterControl>> knobs;
};

} // namespace idiophone
