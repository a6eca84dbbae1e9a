// The outline around the window while the user drags files over it, with what a drop does.
#pragma once

#include "Editor/Look.h"

namespace idiophone {

/// Covers the window and ignores the mouse. OpenGL covers components over its picture, so the frame
/// uses only the window's margin and top.
class DropFrame final : public juce::Component {
public:
    DropFrame() {
        setInterceptsMouseClicks(false, false);
        setAccessible(false);
    }

    /// Shows what a drop does, or why it does nothing.
    void show(const juce::String& whatDropDoes, bool opensFiles) {
        sentence = whatDropDoes;
        isOffer = opensFiles;
        setVisible(true);
        toFront(false);
        repaint();
    }
    void hide() { setVisible(false); }
    const juce::String& shownSentence() const { return sentence; }

    void paint(juce::Graphics& g) override {
        const auto band = getLocalBounds().removeFromTop(40);
        g.setColour(colourOf(*this, isOffer ? LookColour::accent : LookColour::error));
        g.drawRect(getLocalBounds(), 4);
        g.fillRect(band);
        g.setColour(colourOf(*this, isOffer ? LookColour::onAccent : LookColour::background));
        g.setFont(Look::headingFont(16));
        g.drawFittedText(sentence, band.reduced(12, 0), juce::Justification::centred, 1, 0.7f);
    }

private:
    juce::String sentence;
    bool isOffer = true;
};

} // namespace idiophone
