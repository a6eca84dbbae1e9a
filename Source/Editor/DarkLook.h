// Colours, fonts and the few shapes that differ from JUCE's own look.
#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

namespace palette {
inline const juce::Colour background{0xff15171b};
inline const juce::Colour panel{0xff1d2026};
inline const juce::Colour outline{0xff2e333c};
inline const juce::Colour text{0xffe3e6eb};
inline const juce::Colour dimText{0xff9aa3b2};
inline const juce::Colour accent{0xffdca65f};
inline const juce::Colour error{0xffff8a75};
} // namespace palette

class DarkLook final : public juce::LookAndFeel_V4 {
public:
    DarkLook();

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
};

} // namespace idiophone
