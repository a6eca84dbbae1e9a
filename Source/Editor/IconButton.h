// A button with an icon; title and tooltip say what it does.
#pragma once

#include "Editor/Look.h"
#include "Editor/ParameterMenu.h"

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

/// Needs 24 x 24 pixels. An active toggle fills the icon with the accent colour.
class IconButton : public juce::Button {
public:
    IconButton(const juce::String& title, juce::Path icon)
        : Button(title), picture(std::move(icon)) {
        describe(title, title);
    }

    /// Optional. Called on a right click, an Alt-click and the keys of `asksForMenu`.
    std::function<void()> onMenu;

    /// Sets another icon for the off state of a toggle.
    void setPictureOff(juce::Path icon) { pictureOff = std::move(icon); }

    /// Sets the colour of an active toggle.
    void setActiveColour(LookColour colour) { activeColour = colour; }

    /// Sets the texts for the screen reader and the mouse.
    void describe(const juce::String& title, const juce::String& tooltip) {
        if (title != getTitle())
            setTitle(title);
        if (tooltip != getTooltip())
            setTooltip(tooltip);
    }

    void paintButton(juce::Graphics& g, bool highlighted, bool down) override {
        const auto area = getLocalBounds().toFloat();
        if ((highlighted || down) && isEnabled()) {
            g.setColour(
                colourOf(*this, LookColour::outline).withMultipliedAlpha(down ? 1.0f : 0.6f));
            g.fillRoundedRectangle(area.reduced(1), 4);
        }
        if (hasKeyboardFocus(false)) {
            g.setColour(colourOf(*this, LookColour::accent));
            g.drawRoundedRectangle(area.reduced(1.5f), 4, 1.5f);
        }
        const auto colour = !isEnabled()       ? LookColour::outline
                            : getToggleState() ? activeColour
                                               : LookColour::text;
        const float side = juce::jmin(18.0f, area.getWidth() - 8, area.getHeight() - 8);
        const auto square = area.withSizeKeepingCentre(side, side);
        g.setColour(colourOf(*this, colour));
        g.fillPath(getToggleState() || pictureOff.isEmpty() ? picture : pictureOff,
                   juce::AffineTransform::scale(side).translated(square.getX(), square.getY()));
    }
    void mouseDown(const juce::MouseEvent& event) override {
        if (onMenu != nullptr && (event.mods.isPopupMenu() || event.mods.isAltDown()))
            onMenu();
        else
            Button::mouseDown(event);
    }
    bool keyPressed(const juce::KeyPress& key) override {
        if (onMenu == nullptr || !asksForMenu(key))
            return Button::keyPressed(key);
        onMenu();
        return true;
    }

private:
    juce::Path picture, pictureOff;
    LookColour activeColour = LookColour::accent;
};

} // namespace idiophone
