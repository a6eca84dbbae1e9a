// Colours, fonts and the few shapes that differ from JUCE's own look; one dark and one light.
#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

enum class LookScheme { dark, light };

/// What colours mean, whichever scheme holds. Text in `text`, `dimText`, `accent` and `error` is
/// readable on `background` and `panel`, and `onAccent` on `accent`: WCAG 2.1 AA, 4.5 to 1.
enum class LookColour : int {
    background = 0x1d10000,
    panel,
    outline, ///< and what a control has not filled
    text,
    dimText,
    accent,
    onAccent,
    error,
    count
};

class Look final : public juce::LookAndFeel_V4 {
public:
    explicit Look(LookScheme scheme = LookScheme::dark);

    /// Components learn of it by `sendLookAndFeelChange` of the window that wears the look.
    void setScheme(LookScheme scheme);
    LookScheme scheme() const { return current; }

    static juce::Font textFont(float height = 13.5f);
    static juce::Font headingFont(float height = 12.5f);

    juce::Font getComboBoxFont(juce::ComboBox&) override { return textFont(); }
    juce::Font getPopupMenuFont() override { return textFont(); }
    juce::Font getTextButtonFont(juce::TextButton&, int) override { return textFont(); }
    int getSliderThumbRadius(juce::Slider&) override { return 6; }
    void drawLinearSlider(juce::Graphics& g,
                          int x,
                          int y,
                          int width,
                          int height,
                          float thumb,
                          float lowest,
                          float highest,
                          juce::Slider::SliderStyle style,
                          juce::Slider& slider) override;
    void drawToggleButton(juce::Graphics& g,
                          juce::ToggleButton& button,
                          bool highlighted,
                          bool down) override;

private:
    LookScheme current;
};

/// Of the look that the component wears.
juce::Colour colourOf(const juce::Component& component, LookColour colour);

/// Of a scheme, for what is no component.
juce::Colour colourOf(LookScheme scheme, LookColour colour);

} // namespace idiophone
