#include "Editor/DarkLook.h"

namespace idiophone {

DarkLook::DarkLook()
    : LookAndFeel_V4({palette::background, palette::panel, palette::panel, palette::outline,
                      palette::text, palette::outline, palette::background, palette::accent,
                      palette::text}) {
    setColour(juce::Label::textColourId, palette::text);
    setColour(juce::Label::textWhenEditingColourId, palette::text);
    setColour(juce::TextEditor::focusedOutlineColourId, palette::accent);
    setColour(juce::TextEditor::highlightColourId, palette::accent.withAlpha(0.35f));
    setColour(juce::ComboBox::backgroundColourId, palette::background);
    setColour(juce::ComboBox::arrowColourId, palette::dimText);
    setColour(juce::TextButton::buttonColourId, palette::background);
    setColour(juce::TooltipWindow::backgroundColourId, palette::outline);
    setColour(juce::TooltipWindow::textColourId, palette::text);
}

juce::Font DarkLook::textFont(float height) {
    return juce::Font(juce::FontOptions(height));
}

juce::Font DarkLook::headingFont(float height) {
    return juce::Font(juce::FontOptions(height, juce::Font::bold));
}

void DarkLook::drawLinearSlider(juce::Graphics& g,
                                int x,
                                int y,
                                int width,
                                int height,
                                float thumb,
                                float,
                                float,
                                juce::Slider::SliderStyle,
                                juce::Slider& slider) {
    constexpr float thickness = 4, knob = 6;
    const float middle = static_cast<float>(y) + static_cast<float>(height) / 2;
    const juce::Rectangle<float> track(static_cast<float>(x), middle - thickness / 2,
                                       static_cast<float>(width), thickness);
    const bool lively = slider.isMouseOverOrDragging() || slider.hasKeyboardFocus(true);
    g.setColour(palette::outline);
    g.fillRoundedRectangle(track, thickness / 2);
    g.setColour(palette::accent.withMultipliedAlpha(lively ? 1.0f : 0.75f));
    g.fillRoundedRectangle(track.withRight(thumb), thickness / 2);
    g.fillEllipse(juce::Rectangle<float>(2 * knob, 2 * knob).withCentre({thumb, middle}));
}

void DarkLook::drawToggleButton(juce::Graphics& g,
                                juce::ToggleButton& button,
                                bool highlighted,
                                bool) {
    constexpr float height = 16;
    const auto area = button.getLocalBounds().toFloat();
    const auto track = juce::Rectangle<float>(2 * height - 2, height)
                           .withCentre({area.getRight() - height, area.getCentreY()});
    const bool on = button.getToggleState();
    const auto colour = on ? palette::accent : palette::outline;
    g.setColour(highlighted ? colour.brighter(0.15f) : colour);
    g.fillRoundedRectangle(track, height / 2);
    g.setColour(on ? palette::background : palette::dimText);
    const auto side = on ? track.withLeft(track.getRight() - height) : track.withWidth(height);
    g.fillEllipse(side.reduced(3));
}

} // namespace idiophone
