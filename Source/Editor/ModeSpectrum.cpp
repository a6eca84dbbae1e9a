#include "Editor/ModeSpectrum.h"

#include "Editor/Look.h"
#include "Editor/ModeText.h"

#include <algorithm>

namespace idiophone {

ModeSpectrum::ModeSpectrum(SoundView& soundView)
    : DescribedComponent(juce::AccessibilityRole::slider), view(soundView) {
    setTitle("Modes");
    setDescription("Arrows choose a mode, M mutes it, S lets it be heard alone");
    setTooltip("Click a mode to mute it, Alt-click to hear it alone");
    setWantsKeyboardFocus(true);
}

void ModeSpectrum::show(const SoundFrame& next) {
    const bool isOther = next.object != frame.object ||
                         next.instrumentNumber != frame.instrumentNumber ||
                         next.modes.size() != frame.modes.size();
    frame = next;
    if (isOther)
        hovered = chosen = std::nullopt;
    if (picture.update(frame, getLocalBounds()) || isOther)
        repaint();
    if (onModeShown && (isOther || modeShown()))
        onModeShown();
}

void ModeSpectrum::choose(std::optional<std::size_t> mode) {
    if (mode && *mode >= frame.modes.size())
        return;
    chosen = mode;
    modeChanged();
}

void ModeSpectrum::hover(std::optional<std::size_t> mode) {
    if (mode == hovered)
        return;
    hovered = mode;
    modeChanged();
}

void ModeSpectrum::modeChanged() {
    repaint();
    if (onModeShown)
        onModeShown();
    notifyDescriptionChanged();
}

void ModeSpectrum::toggle(std::size_t mode,
                          bool ModeNow::*state,
                          bool (SoundView::*set)(std::size_t, std::int32_t, bool)) {
    if (mode >= frame.modes.size() || frame.object < 0)
        return;
    bool& now = frame.modes[mode].*state;
    if ((view.*set)(static_cast<std::size_t>(frame.object), static_cast<std::int32_t>(mode), !now))
        now = !now;
    picture.update(frame, getLocalBounds());
    modeChanged();
}

void ModeSpectrum::mouseDown(const juce::MouseEvent& event) {
    const auto mode = modeAt(event.position);
    if (!mode || !event.mods.isLeftButtonDown())
        return;
    chosen = mode;
    if (event.mods.isAltDown())
        toggleAlone(*mode);
    else
        toggleMute(*mode);
}

bool ModeSpectrum::keyPressed(const juce::KeyPress& key) {
    const std::size_t count = frame.modes.size();
    if (count == 0)
        return false;
    const bool isCommanded = key.getModifiers().isCommandDown() || key.getModifiers().isCtrlDown();
    const auto character =
        isCommanded ? 0 : juce::CharacterFunctions::toLowerCase(key.getTextCharacter());
    if (key == juce::KeyPress::rightKey || key == juce::KeyPress::upKey)
        choose(chosen ? std::min(*chosen + 1, count - 1) : 0);
    else if (key == juce::KeyPress::leftKey || key == juce::KeyPress::downKey)
        choose(chosen && *chosen > 0 ? *chosen - 1 : 0);
    else if (key == juce::KeyPress::homeKey)
        choose(0);
    else if (key == juce::KeyPress::endKey)
        choose(count - 1);
    else if (key == juce::KeyPress::escapeKey && chosen)
        choose(std::nullopt);
    else if (character == 'm' && chosen)
        toggleMute(*chosen);
    else if (character == 's' && chosen)
        toggleAlone(*chosen);
    else
        return false;
    return true;
}

bool ModeSpectrum::keyStateChanged(bool) {
    return juce::JUCEApplicationBase::isStandaloneApp(); // in a plugin, pass keys on to the host
}

juce::String ModeSpectrum::description() const {
    const auto mode = modeShown();
    return mode ? describeMode(frame, *mode).joinIntoString(", ")
                : juce::String(frame.modes.size()) + " modes";
}

void ModeSpectrum::paint(juce::Graphics& g) {
    g.setColour(colourOf(*this, LookColour::background));
    g.fillRoundedRectangle(getLocalBounds().toFloat(), 5);
    g.setColour(
        colourOf(*this, hasKeyboardFocus(false) ? LookColour::accent : LookColour::outline));
    g.drawRoundedRectangle(getLocalBounds().toFloat().reduced(0.5f), 5, 1);
    picture.paint(g, *this, modeShown());
}

} // namespace idiophone
