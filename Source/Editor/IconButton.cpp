#include "Editor/IconButton.h"

#include "Editor/Look.h"
#include "Editor/ParameterMenu.h"

namespace idiophone {

IconButton::IconButton(const juce::String& title, juce::Path icon)
    : Button(title), picture(std::move(icon)) {
    describe(title, title);
}

void IconButton::describe(const juce::String& title, const juce::String& tooltip) {
    if (title != getTitle())
        setTitle(title);
    if (tooltip != getTooltip())
        setTooltip(tooltip);
}

void IconButton::paintButton(juce::Graphics& g, bool highlighted, bool down) {
    const auto area = getLocalBounds().toFloat();
    if ((highlighted || down) && isEnabled()) {
        g.setColour(colourOf(*this, LookColour::outline).withMultipliedAlpha(down ? 1.0f : 0.6f));
        g.fillRoundedRectangle(area.reduced(1), 4);
    }
    if (hasKeyboardFocus(false)) {
        g.setColour(colourOf(*this, LookColour::accent));
        g.drawRoundedRectangle(area.reduced(1.5f), 4, 1.5f);
    }
    const auto colour = !isEnabled()       ? LookColour::outline
                        : getToggleState() ? LookColour::accent
                                           : LookColour::text;
    const float side = juce::jmin(18.0f, area.getWidth() - 8, area.getHeight() - 8);
    const auto square = area.withSizeKeepingCentre(side, side);
    g.setColour(colourOf(*this, colour));
    g.fillPath(getToggleState() || pictureOff.isEmpty() ? picture : pictureOff,
               juce::AffineTransform::scale(side).translated(square.getX(), square.getY()));
}

void IconButton::mouseDown(const juce::MouseEvent& event) {
    if (onMenu != nullptr && (event.mods.isPopupMenu() || event.mods.isAltDown()))
        onMenu();
    else
        Button::mouseDown(event);
}

bool IconButton::keyPressed(const juce::KeyPress& key) {
    if (onMenu == nullptr || !asksForMenu(key))
        return Button::keyPressed(key);
    onMenu();
    return true;
}

} // namespace idiophone
