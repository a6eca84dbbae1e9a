// Three hints over the picture, one after the other, for the first start.
#pragma once

#include "Editor/DescribedComponent.h"
#include "Editor/Look.h"

#include <array>
#include <cstddef>

namespace idiophone {

/// A child of the picture, which OpenGL then draws with it. Ignores the mouse; a click on the
/// picture fades the current hint. A timer runs only until the last hint has faded.
class FirstHints final : public DescribedComponent, private juce::Timer {
public:
    static constexpr std::array texts{
        "Click the instrument to strike it. Lower down, or with a faster mouse, it is louder.",
        "Drag over it to scrape it. Drag beside it to turn the view.",
        "Drag a mesh from your files onto the window to play it."};

    FirstHints() : DescribedComponent(juce::AccessibilityRole::staticText) {
        setTitle("Hint");
        setInterceptsMouseClicks(false, false);
        setVisible(false);
    }
    ~FirstHints() override { stop(); }

    /// Shows the first hint. The component has a parent.
    void start() {
        getParentComponent()->addMouseListener(this, false);
        setVisible(true);
        show(0);
    }
    bool isRunning() const { return isTimerRunning(); }

    /// Lets the current hint fade from now on.
    void fade() {
        if (!isRunning() || opacity < 1)
            return;
        opacity = 1 - opacityStep;
        startTimer(fadeStepMilliseconds);
        repaint();
    }

    juce::String description() const override { return texts[current]; }
    void parentSizeChanged() override { place(); }
    void mouseDown(const juce::MouseEvent&) override { fade(); }

    void paint(juce::Graphics& g) override {
        const auto area = getLocalBounds().toFloat();
        g.setColour(colourOf(*this, LookColour::panel).withAlpha(0.9f * opacity));
        g.fillRoundedRectangle(area, 8);
        g.setColour(colourOf(*this, LookColour::accent).withAlpha(opacity));
        g.drawRoundedRectangle(area.reduced(0.75f), 8, 1.5f);
        g.setColour(colourOf(*this, LookColour::text).withAlpha(opacity));
        g.setFont(font());
        g.drawFittedText(description(), getLocalBounds().reduced(padding, 4),
                         juce::Justification::centred, 2);
    }

private:
    static constexpr int holdMilliseconds = 6000, fadeStepMilliseconds = 60;
    static constexpr float opacityStep = 0.1f;
    static constexpr int padding = 14, lineHeight = 36, foot = 14;

    static juce::Font font() { return Look::headingFont(15); }

    void show(std::size_t hint) {
        current = hint;
        opacity = 1;
        place();
        repaint();
        startTimer(holdMilliseconds);
        notifyDescriptionChanged();
        juce::AccessibilityHandler::postAnnouncement(
            description(), juce::AccessibilityHandler::AnnouncementPriority::medium);
    }
    void stop() {
        stopTimer();
        setVisible(false);
        if (auto* parent = getParentComponent())
            parent->removeMouseListener(this);
    }
    /// At the foot of the picture, on two lines if one is too narrow.
    void place() {
        const auto* parent = getParentComponent();
        if (parent == nullptr)
            return;
        const int whole =
            juce::GlyphArrangement::getStringWidthInt(font(), description()) + 2 * padding + 2;
        const int width = juce::jmin(whole, parent->getWidth() - 2 * padding);
        const int height = width < whole ? lineHeight + 20 : lineHeight;
        setBounds((parent->getWidth() - width) / 2, parent->getHeight() - height - foot, width,
                  height);
    }
    void timerCallback() override {
        if (opacity == 1)
            return fade();
        opacity -= opacityStep;
        if (opacity > 0)
            return repaint();
        if (current + 1 < texts.size())
            show(current + 1);
        else
            stop();
    }

    std::size_t current = 0;
    float opacity = 1;
};

} // namespace idiophone
