// Sentences about work that is done, which can be read, scrolled and copied.
#pragma once

#include "Editor/Look.h"

#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

class ReportText final : public juce::TextEditor {
public:
    explicit ReportText(const juce::String& title) {
        setTitle(title);
        setMultiLine(true);
        setReadOnly(true);
        setCaretVisible(false);
        setFont(Look::textFont());
        setIndents(0, 2);
    }

    void show(const juce::String& text, LookColour colour) {
        setColour(textColourId, colourOf(*this, colour));
        if (getText() != text) {
            setText(text, false);
            moveCaretToTop(false);
        }
        applyColourToAllText(findColour(textColourId));
    }

    void lookAndFeelChanged() override {
        TextEditor::lookAndFeelChanged();
        setColour(backgroundColourId, juce::Colours::transparentBlack);
        setColour(outlineColourId, juce::Colours::transparentBlack);
        setColour(focusedOutlineColourId, colourOf(*this, LookColour::outline));
    }
};

} // namespace idiophone
