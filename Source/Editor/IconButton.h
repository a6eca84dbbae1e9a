// A button with an icon; title and tooltip say what it does.
#pragma once

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

/// Needs 24 x 24 pixels. An active toggle fills the icon with the accent colour.
class IconButton final : public juce::Button {
public:
    IconButton(const juce::String& title, juce::Path icon);

    /// Optional. Called on a right click, an Alt-click and the keys of `asksForMenu`.
    std::function<void()> onMenu;

    /// Sets another icon for the off state of a toggle.
    void setPictureOff(juce::Path icon) { pictureOff = std::move(icon); }

    /// Sets the texts for the screen reader and the mouse.
    void describe(const juce::String& title, const juce::String& tooltip);

    void paintButton(juce::Graphics& g, bool highlighted, bool down) override;
    void mouseDown(const juce::MouseEvent& event) override;
    bool keyPressed(const juce::KeyPress& key) override;

private:
    juce::Path picture, pictureOff;
};

} // namespace idiophone
