// The spectrum of an object's modes: frequency, current level and decay time of each. A click mutes
// a mode.
#pragma once

#include "Editor/DescribedComponent.h"
#include "Editor/SoundView.h"
#include "Editor/SpectrumPicture.h"

#include <functional>
#include <optional>

namespace idiophone {

/// Needs at least 340 x 150 px. Arrows choose a mode, M mutes it and S solos it. A click mutes the
/// mode under the mouse; an Alt-click solos it.
class ModeSpectrum final : public DescribedComponent {
public:
    explicit ModeSpectrum(SoundView& view);

    /// Repaints only if the picture changes.
    void show(const SoundFrame& next);

    /// The mode of the last frame under the mouse, or else the chosen one.
    std::optional<std::size_t> modeShown() const { return hovered ? hovered : chosen; }
    /// The mode that a click, the arrows or `choose` selected.
    std::optional<std::size_t> modeChosen() const { return chosen; }
    void choose(std::optional<std::size_t> mode);
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

    juce::String description() const override;
    void paint(juce::Graphics& g) override;
    void resized() override { picture.update(frame, getLocalBounds()); }
    void mouseMove(const juce::MouseEvent& event) override { hover(modeAt(event.position)); }
    void mouseExit(const juce::MouseEvent&) override { hover(std::nullopt); }
    void mouseDown(const juce::MouseEvent& event) override;
    bool keyPressed(const juce::KeyPress& key) override;
    bool keyStateChanged(bool) override; ///< keeps M and S from playing notes
    void focusGained(FocusChangeType) override { repaint(); }
    void focusLost(FocusChangeType) override { repaint(); }

private:
    void toggle(std::size_t mode,
                bool ModeNow::*state,
                bool (SoundView::*set)(std::size_t object, std::int32_t mode, bool state));
    void hover(std::optional<std::size_t> mode);
    void modeChanged();

    SoundView& view;
    SoundFrame frame;
    SpectrumPicture picture;
    std::optional<std::size_t> hovered, chosen;
};

} // namespace idiophone
