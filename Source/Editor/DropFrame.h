// The outline around the window while the user drags a readable file over it.
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

    /// Shows the file's name, without its folder. An empty name hides the frame.
    void show(const juce::String& fileName) {
        name = fileName;
        setVisible(name.isNotEmpty());
        toFront(false);
        repaint();
    }

    void paint(juce::Graphics& g) override {
        const auto band = getLocalBounds().removeFromTop(40);
        g.setColour(colourOf(*this, LookColour::accent));
        g.drawRect(getLocalBounds(), 4);
        g.fillRect(band);
        g.setColour(colourOf(*this, LookColour::onAccent));
        g.setFont(Look::headingFont(16));
        g.drawFittedText("Drop to play " + name, band.reduced(12, 0), juce::Justification::centred,
                         1, 0.7f);
    }

private:
    juce::String name;
};

} // namespace idiophone
