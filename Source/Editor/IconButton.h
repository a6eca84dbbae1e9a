// A button that shows a picture; what it does stands in its title and tooltip.
#pragma once

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

/// Needs 24 x 24 pixels. Where it is a toggle, the picture is filled with the accent while it is
/// on.
class IconButton final : public juce::Button {
public:
    IconButton(const juce::String& title, juce::Path icon);

    /// Shows a menu on a right click, a click with the Alt key and the keys of `asksForMenu`.
    /// Optional.
    std::function<void()> onMenu;

    /// The picture while a toggle is off, where it is another one.
    void setPictureOff(juce::Path icon) { pictureOff = std::move(icon); }

    /// What a screen reader says, and the mouse shows.
    void describe(const juce::String& title, const juce::String& tooltip);

    void paintButton(juce::Graphics& g, bool highlighted, bool down) override;
    void mouseDown(const juce::MouseEvent& event) override;
    bool keyPressed(const juce::KeyPress& key) override;

private:
    juce::Path picture, pictureOff;
};

} // namespace idiophone
