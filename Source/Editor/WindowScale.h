// The scale of the window: the limits of its size, what fits the screen, and the button that
// chooses it.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

/// Sizes of the window before it is scaled.
struct WindowSize {
    static constexpr int minimumWidth = 800, minimumHeight = 500;
    static constexpr int maximumWidth = 3840, maximumHeight = 2160;
    static constexpr int firstWidth = 1180, firstHeight = 860;

    /// The primary screen's area without task bars, at a scale of 1; the maximum size without a
    /// screen.
    static juce::Rectangle<int> screen() {
        const auto& desktop = juce::Desktop::getInstance();
        const auto* primary = desktop.getDisplays().getPrimaryDisplay();
        return primary != nullptr ? primary->userArea * desktop.getGlobalScaleFactor()
                                  : juce::Rectangle<int>(maximumWidth, maximumHeight);
    }
    /// The same without the frame that JUCE's standalone draws around the window.
    static juce::Rectangle<int> framedScreen(float scale) {
        constexpr float frameWidth = 8, frameHeight = 34;
        return screen()
            .withTrimmedRight(juce::roundToInt(frameWidth * scale))
            .withTrimmedBottom(juce::roundToInt(frameHeight * scale));
    }
    /// Moves a window, which is no larger, to where all of it is on the screen.
    static void keepOnScreen(juce::Component& window) {
        const auto area = screen() / juce::Desktop::getInstance().getGlobalScaleFactor();
        window.setBounds(window.getBounds().constrainedWithin(area));
    }
    /// Whether the smallest window fits the screen at this scale.
    static bool fits(int percent, juce::Rectangle<int> screen) {
        return minimumWidth * percent <= 100 * screen.getWidth() &&
               minimumHeight * percent <= 100 * screen.getHeight();
    }
    /// Limits a size to the screen and to the window's limits. For (0, 0), starts from the first
    /// size.
    static juce::Point<int>
    within(juce::Rectangle<int> screen, juce::Point<int> size, float scale) {
        const auto fitting = [scale](int wanted, int first, int minimum, int onScreen) {
            const int maximum = juce::roundToInt(float(onScreen) / scale);
            return juce::jlimit(minimum, std::max(minimum, maximum), wanted > 0 ? wanted : first);
        };
        return {fitting(size.x, firstWidth, minimumWidth, screen.getWidth()),
                fitting(size.y, firstHeight, minimumHeight, screen.getHeight())};
    }
};

/// The limits of the window's size. JUCE's standalone also asks them about its own window, which is
/// not scaled.
class WindowLimits final : public juce::ComponentBoundsConstrainer {
public:
    explicit WindowLimits(const juce::Component& editorWindow) : editor(editorWindow) {
        setLimits(*this, 1);
    }

    void setScale(float scale) { setLimits(scaled, scale); }

    /// `before` are the editor's bounds, or those of another window.
    void checkBounds(juce::Rectangle<int>& bounds,
                     const juce::Rectangle<int>& before,
                     const juce::Rectangle<int>& limits,
                     bool top,
                     bool left,
                     bool bottom,
                     bool right) override {
        if (before == editor.getBounds())
            ComponentBoundsConstrainer::checkBounds(bounds, before, limits, top, left, bottom,
                                                    right);
        else
            scaled.checkBounds(bounds, before, limits, top, left, bottom, right);
    }

private:
    static void setLimits(ComponentBoundsConstrainer& of, float scale) {
        const auto times = [scale](int length) { return juce::roundToInt(float(length) * scale); };
        of.setSizeLimits(times(WindowSize::minimumWidth), times(WindowSize::minimumHeight),
                         times(WindowSize::maximumWidth), times(WindowSize::maximumHeight));
    }

    const juce::Component& editor;
    juce::ComponentBoundsConstrainer scaled; ///< for a window around the editor
};

/// Shows the scale, and offers the others in a menu.
class ScaleButton final : public juce::TextButton {
public:
    static constexpr std::array percents{75, 100, 125, 150, 175, 200};
    static constexpr int width = 58;

    ScaleButton() {
        setTitle("Scale");
        setTooltip("Make the window and its text larger or smaller");
        onClick = [this] { showMenu(); };
    }

    /// The largest scale up to `percent` whose smallest window fits the screen, or the smallest.
    static int fitting(int percent, juce::Rectangle<int> screen) {
        int best = percents.front();
        for (const int each : percents)
            if (each <= percent && WindowSize::fits(each, screen))
                best = each;
        return best;
    }

    std::function<void(int percent)> onScale;

    void show(int percent) {
        shown = percent;
        setButtonText(juce::String(percent) + " %");
    }
    /// A scale whose smallest window exceeds the screen cannot be chosen.
    juce::PopupMenu menu(juce::Rectangle<int> screen) {
        juce::PopupMenu result;
        const juce::Component::SafePointer<ScaleButton> self(this);
        for (const int percent : percents)
            result.addItem(juce::String(percent) + " %", WindowSize::fits(percent, screen),
                           percent == shown, [self, percent] {
                               if (self != nullptr)
                                   juce::NullCheckedInvocation::invoke(self->onScale, percent);
                           });
        return result;
    }

private:
    void showMenu() {
        auto popup = menu(WindowSize::screen());
        popup.setLookAndFeel(&getLookAndFeel());
        popup.showMenuAsync(
            juce::PopupMenu::Options().withTargetComponent(*this).withDeletionCheck(*this));
    }

    int shown = 100;
};

} // namespace idiophone
