// Colours, fonts and shapes of the window in a dark and a light scheme, and functions that many of
// its parts share.
#pragma once

#include <juce_gui_basics/juce_gui_basics.h>
#include <optional>

namespace idiophone {

enum class LookScheme { dark, light };

/// Roles of colours in both schemes. `text`, `dimText`, `accent` and `error` are readable on
/// `background` and `panel`, and `onAccent` on `accent` (WCAG 2.1 AA, contrast 4.5 to 1).
enum class LookColour : int {
    background = 0x1d10000,
    panel,
    outline, ///< also the unfilled part of a control
    text,
    dimText,
    accent,
    onAccent,
    error,
    held, ///< where an object is held; readable as `text` is
    count
};

class Look final : public juce::LookAndFeel_V4 {
public:
    explicit Look(LookScheme scheme = LookScheme::dark);

    /// To update components, call `sendLookAndFeelChange` of the window that uses this look.
    void setScheme(LookScheme scheme);
    LookScheme scheme() const { return current; }

    /// Sets the part of a slider's range, as places from 0 to 1, that a line beside it marks as
    /// moved by modulation; nothing: no line. Repaints the slider if this changes.
    static void showModulation(juce::Slider& slider, std::optional<juce::Range<double>> places);

    static juce::Font textFont(float height = 13.5f);
    static juce::Font headingFont(float height = 12.5f);

    juce::Font getComboBoxFont(juce::ComboBox&) override { return textFont(); }
    juce::Font getPopupMenuFont() override { return textFont(); }
    juce::Font getTextButtonFont(juce::TextButton&, int) override { return textFont(); }
    juce::Font getAlertWindowTitleFont() override { return headingFont(16); }
    juce::Font getAlertWindowMessageFont() override { return textFont(14.5f); }
    juce::Font getAlertWindowFont() override { return textFont(); }
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
    void drawRotarySlider(juce::Graphics& g,
                          int x,
                          int y,
                          int width,
                          int height,
                          float place,
                          float startAngle,
                          float endAngle,
                          juce::Slider& slider) override;
    void drawToggleButton(juce::Graphics& g,
                          juce::ToggleButton& button,
                          bool highlighted,
                          bool down) override;
    void drawAlertBox(juce::Graphics& g,
                      juce::AlertWindow& alert,
                      const juce::Rectangle<int>& textArea,
                      juce::TextLayout& text) override;
    /// The buttons of the standalone's title bar and of dialogs.
    juce::Button* createDocumentWindowButton(int type) override;
    void drawResizableWindowBorder(juce::Graphics& g,
                                   int width,
                                   int height,
                                   const juce::BorderSize<int>& border,
                                   juce::ResizableWindow& window) override;
    /// A row of the file chooser where the system has none.
    void drawFileBrowserRow(juce::Graphics& g,
                            int width,
                            int height,
                            const juce::File& file,
                            const juce::String& name,
                            juce::Image* icon,
                            const juce::String& size,
                            const juce::String& time,
                            bool isFolder,
                            bool isSelected,
                            int index,
                            juce::DirectoryContentsDisplayComponent& list) override;

private:
    LookScheme current;
};

/// A label without border. A text that does not fit becomes narrower.
class TextLabel final : public juce::Label {
public:
    TextLabel() {
        setFont(Look::textFont());
        setBorderSize({});
        setMinimumHorizontalScale(0.8f);
    }
};

juce::Colour colourOf(const juce::Component& component, LookColour colour);

/// The colour in a scheme, for code without a component.
juce::Colour colourOf(LookScheme scheme, LookColour colour);

template <class... Parts>
void showParts(juce::Component& parent, Parts&... parts) {
    (parent.addAndMakeVisible(parts), ...);
}

/// Draws a selected row of a list, and whether the list has the focus.
void drawSelectedRow(juce::Graphics& g, juce::Rectangle<int> row, const juce::ListBox& list);

/// Colours text that was typed into `part` and its children. JUCE keeps its old colour otherwise.
void recolourTexts(juce::Component& part);

} // namespace idiophone
