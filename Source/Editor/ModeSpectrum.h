// The spectrum of an object's modes: frequency, current level and decay time of each. A click mutes
// a mode.
#pragma once

#include "Editor/SoundView.h"
#include "Editor/SpectrumScale.h"

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <optional>
#include <vector>

namespace idiophone {

/// Needs at least 340 x 150 px. Arrows choose a mode, M mutes it and S solos it. A click mutes the
/// mode under the mouse; an Alt-click solos it.
class ModeSpectrum final : public juce::Component, public juce::SettableTooltipClient {
public:
    explicit ModeSpectrum(SoundView& view);

    /// Repaints only if the picture changes.
    void show(const SoundFrame& frame);

    /// The mode of the last frame under the mouse, or else the chosen one.
    std::optional<std::size_t> modeShown() const;
    /// The mode that a click, the arrows or `choose` selected.
    std::optional<std::size_t> modeChosen() const { return chosen; }
    void choose(std::optional<std::size_t> mode);
    const SoundFrame& frameShown() const { return frame; }

    /// These two do nothing if the mode does not exist.
    void toggleMute(std::size_t mode);
    void toggleAlone(std::size_t mode);

    std::optional<std::size_t> modeAt(juce::Point<float> position) const;

    /// Called after `modeShown` or its values have changed.
    std::function<void()> onModeShown;

    void paint(juce::Graphics& g) override;
    void resized() override;
    void mouseMove(const juce::MouseEvent& event) override;
    void mouseExit(const juce::MouseEvent& event) override;
    void mouseDown(const juce::MouseEvent& event) override;
    bool keyPressed(const juce::KeyPress& key) override;
    bool keyStateChanged(bool) override; ///< keeps M and S from playing notes
    void focusGained(FocusChangeType) override { repaint(); }
    void focusLost(FocusChangeType) override { repaint(); }
    std::unique_ptr<juce::AccessibilityHandler> createAccessibilityHandler() override;

private:
    /// One mode as drawn, in whole pixels, so that equal pictures compare equal.
    struct Line {
        int x = 0;
        int top = 0;
        int decayY = 0;
        std::int32_t group = 0;
        ModeStanding standing = ModeStanding::belowTau;
        bool isMuted = false;
        bool isHeardAlone = false;

        bool operator==(const Line&) const = default;
    };

    juce::Rectangle<float> levelArea() const;
    juce::Rectangle<float> decayArea() const;
    SpectrumScale scaleOf(const SoundFrame& shown) const;
    std::vector<Line> linesOf(const SoundFrame& shown) const;
    void hover(std::optional<std::size_t> mode);
    void modeChanged();
    juce::String description() const;
    juce::Colour colourFor(const Line& line) const;
    void paintScale(juce::Graphics& g) const;
    void paintTau(juce::Graphics& g) const;
    void paintGroups(juce::Graphics& g) const;
    void paintLine(juce::Graphics& g, const Line& line, bool isShown) const;

    SoundView& view;
    SoundFrame frame;
    SpectrumScale scale;
    std::vector<Line> lines;
    int tauY = 0;
    std::optional<std::size_t> hovered, chosen;
};

} // namespace idiophone
