#include "Editor/ObjectPane.h"

#include "Editor/Look.h"

namespace idiophone {

ObjectPane::ObjectPane(ProcessorView& view) : object(view) {
    addAndMakeVisible(object);
    addSwitch(vibration, "Show how what sounds vibrates, slowed down and exaggerated",
              &ObjectView::setShowsVibration, true);
    addSwitch(nodes, "Show where the strongest mode of what sounds stands still",
              &ObjectView::setShowsNodes, false);
    addSwitch(path, "Show where the keys strike", &ObjectView::setShowsPath, false);
    addSwitch(draw, "Draw over an object to say where the keys strike it",
              &ObjectView::setDrawsPath, false);
    draw.onClick = [this, drawn = draw.onClick] {
        drawn();
        if (draw.getToggleState() && !path.getToggleState())
            path.setToggleState(true, juce::sendNotification);
    };
}

void ObjectPane::addSwitch(juce::TextButton& button,
                           const juce::String& tooltip,
                           void (ObjectView::*change)(bool),
                           bool on) {
    button.setTitle(button.getButtonText());
    button.setTooltip(tooltip);
    button.setClickingTogglesState(true);
    button.setToggleState(on, juce::dontSendNotification);
    button.onClick = [this, &button, change] { (object.*change)(button.getToggleState()); };
    addAndMakeVisible(button);
}

void ObjectPane::resized() {
    auto area = getLocalBounds();
    auto strip = area.removeFromTop(stripHeight).withTrimmedBottom(4);
    const juce::Font font = Look::textFont();
    for (auto* button : {&vibration, &nodes, &path, &draw}) {
        const int width = juce::roundToInt(
            juce::GlyphArrangement::getStringWidth(font, button->getButtonText()) + 18);
        button->setBounds(
            strip.removeFromLeft(juce::jmin(width, getWidth() / 4)).withTrimmedRight(4));
    }
    object.setBounds(area);
}

} // namespace idiophone
