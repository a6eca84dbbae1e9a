// The spectrum of an object's modes: frequency, current level and decay time of each. A click mutes
// a mode.
#pragma once

#include "Editor/DescribedComponent.h"
#include "Editor/Look.h"
#include "Editor/ModeText.h"
#include "Editor/SoundView.h"
#include "Editor/SpectrumPicture.h"

#include <algorithm>
#include <functional>
#include <optional>

namespace idiophone {

/// Needs at least 340 x 150 px. Arrows choose a mode, M mutes it and S solos it. A click mutes the
/// mode under the mouse; an Alt-click solos it.
class ModeSpectrum final : public DescribedComponent {
public:
    explicit ModeSpectrum(SoundView& soundView)
        : DescribedComponent(juce::AccessibilityRole::slider), view(soundView) {
        setTitle("Modes");
        setDescription("Arrows choose a mode, M mutes it, S lets it be heard alone");
        setTooltip("Click a mode to mute it, Alt-click to hear it alone");
        setWantsKeyboardFocus(true);
    }

    /// Repaints only if the picture changes.
    void show(const SoundFrame& next) {
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

    /// The mode of the last frame under the mouse, or else the chosen one.
    std::optional<std::size_t> modeShown() const { return hovered ? hovered : chosen; }
    /// The mode that a click, the arrows or `choose` selected.
    std::optional<std::size_t> modeChosen() const { return chosen; }
    void choose(std::optional<std::size_t> mode) {
        if (mode && *mode >= frame.modes.size())
            return;
        chosen = mode;
        modeChanged();
    }
    const SoundFrame& frameShown() const { return frame; }

    /// `toggleMute` and `toggleAlone` do nothing if the mode does not exist.
    void toggleMute(std::size_t mode) { toggle(mode, &ModeNow::isMuted, &SoundView::muteMode); }
    void toggleAlone(std::size_t mode) {
        toggle(mode, &ModeNow::isHeardAlone, &SoundView::hearModeAlone);
    }

    std::optional<std::size_t> modeAt(juce::Point<float> position) const {
        return picture.modeAt(position);
    }

    /// Called after `modeShown` or its values have changed.
    std::function<void()> onModeShown;

    juce::String description() const override {
        const auto mode = modeShown();
        return mode ? describeMode(frame, *mode).joinIntoString(", ")
                    : juce::String(frame.modes.size()) + " modes";
    }
    void paint(juce::Graphics& g) override {
        g.setColour(colourOf(*this, LookColour::background));
        g.fillRoundedRectangle(getLocalBounds().toFloat(), 5);
        g.setColour(
            colourOf(*this, hasKeyboardFocus(false) ? LookColour::accent : LookColour::outline));
        g.drawRoundedRectangle(getLocalBounds().toFloat().reduced(0.5f), 5, 1);
        picture.paint(g, *this, modeShown());
    }
    void resized() override { picture.update(frame, getLocalBounds()); }
    void mouseMove(const juce::MouseEvent& event) override { hover(modeAt(event.position)); }
    void mouseExit(const juce::MouseEvent&) override { hover(std::nullopt); }
    void mouseDown(const juce::MouseEvent& event) override {
        const auto mode = modeAt(event.position);
        if (!mode || !event.mods.isLeftButtonDown())
            return;
        chosen = mode;
        if (event.mods.isAltDown())
            toggleAlone(*mode);
        else
            toggleMute(*mode);
    }
    bool keyPressed(const juce::KeyPress& key) override {
        const std::size_t count = frame.modes.size();
        if (count == 0)
            return false;
        const bool isCommanded =
            key.getModifiers().isCommandDown() || key.getModifiers().isCtrlDown();
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
    /// Keeps M and S from playing notes. In a plugin, passes keys on to the host.
    bool keyStateChanged(bool) override { return juce::JUCEApplicationBase::isStandaloneApp(); }
    void focusGained(FocusChangeType) override { repaint(); }
    void focusLost(FocusChangeType) override { repaint(); }

private:
    void toggle(std::size_t mode,
                bool ModeNow::*state,
                bool (SoundView::*set)(std::size_t, std::int32_t, bool)) {
        if (mode >= frame.modes.size() || frame.object < 0)
            return;
        bool& now = frame.modes[mode].*state;
        if ((view.*set)(static_cast<std::size_t>(frame.object), static_cast<std::int32_t>(mode),
                        !now))
            now = !now;
        picture.update(frame, getLocalBounds());
        modeChanged();
    }
    void hover(std::optional<std::size_t> mode) {
        if (mode == hovered)
            return;
        hovered = mode;
        modeChanged();
    }
    void modeChanged() {
        repaint();
        if (onModeShown)
            onModeShown();
        notifyDescriptionChanged();
    }

    SoundView& view;
    SoundFrame frame;
    SpectrumPicture picture;
    std::optional<std::size_t> hovered, chosen;
};

} // namespace idiophone
