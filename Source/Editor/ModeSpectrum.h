// The modes of an object as lines: where they are, how loud they are now, and how long they ring.
// Clicks mute them.
#pragma once

#include "Editor/SoundView.h"
#include "Editor/SpectrumScale.h"

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <optional>
#include <vector>

namespace idiophone {

/// Readable from 340 x 150 px on. The arrows choose a mode, M mutes it and S lets it be heard
/// alone; a click mutes the mode under the mouse, with Alt it is heard alone.
class ModeSpectrum final : public juce::Component, public juce::SettableTooltipClient {
public:
    explicit ModeSpectrum(SoundView& view);

    /// Repaints where that looks different.
    void show(const SoundFrame& frame);

    /// Under the mouse, or else the one that the arrows chose last, of the frame shown last.
    std::optional<std::size_t> modeShown() const;
    /// Without the mouse.
    std::optional<std::size_t> modeChosen() const { return chosen; }
    void choose(std::optional<std::size_t> mode);
    const SoundFrame& frameShown() const { return frame; }

    /// Changes it where it exists.
    void toggleMute(std::size_t mode);
    void toggleAlone(std::size_t mode);

    /// Which mode is near a place of the component.
    std::optional<std::size_t> modeAt(juce::Point<float> position) const;

    /// After `modeShown` or what is known of it has changed.
    std::function<void()> onModeShown;

    void paint(juce::Graphics& g) override;
    void resized() override;
    void mouseMove(const juce::MouseEvent& event) override;
    void mouseExit(const juce::MouseEvent& event) override;
    void mouseDown(const juce::MouseEvent& event) override;
    bool keyPressed(const juce::KeyPress& key) override;
    bool keyStateChanged(bool) override; ///< its letters are no notes
    void focusGained(FocusChangeType) override { repaint(); }
    void focusLost(FocusChangeType) override { repaint(); }
    std::unique_ptr<juce::AccessibilityHandler> createAccessibilityHandler() override;

private:
    /// One mode as it is drawn; whole pixels, so that what looks the same is the same.
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
