// A page of the deck that contains only parameters.
#pragma once

#include "Editor/DeckPage.h"
#include "Editor/ParameterColumns.h"

#include <span>

namespace idiophone {

class ParameterPage final : public DeckPage {
public:
    ParameterPage(const juce::String& title,
                  std::span<const ParameterGroup> groups,
                  ProcessorView& view)
        : DeckPage(title), columns(groups, view) {
        addAndMakeVisible(columns);
    }

    void refresh() override { columns.refresh(); }
    void resized() override { columns.setBounds(getLocalBounds().reduced(padding)); }

private:
    ParameterColumns columns;
};

} // namespace idiophone
