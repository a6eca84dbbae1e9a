#include "Editor/DropFrame.h"

#include "Editor/Look.h"

namespace idiophone {

void DropFrame::show(const juce::String& fileName) {
    name = fileName;
    setVisible(name.isNotEmpty());
    toFront(false);
    repaint();
}

void DropFrame::paint(juce::Graphics& g) {
    constexpr int bandHeight = 40;
    const auto accent = colourOf(*this, LookColour::accent);
    g.setColour(accent);
    g.drawRect(getLocalBounds(), 4);
    g.fillRect(getLocalBounds().removeFromTop(bandHeight));
    g.setColour(colourOf(*this, LookColour::onAccent));
    g.setFont(Look::headingFont(16));
    g.drawFittedText("Drop to play " + name,
                     getLocalBounds().removeFromTop(bandHeight).reduced(12, 0),
                     juce::Justification::centred, 1, 0.7f);
}

} // namespace idiophone
