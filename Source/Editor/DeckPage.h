// Base class of the pages in the deck, below or beside the picture of the instrument.
#pragma once

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <utility>

namespace idiophone {

struct SoundFrame;

/// The component's name is the text of the tab.
class DeckPage : public juce::Component {
public:
    /// The smallest size that every page must support.
    static constexpr int minimumWidth = 380, minimumHeight = 290;
    /// The largest size of a page.
    static constexpr int maximumWidth = 640, maximumHeight = 460;
    static constexpr int padding = 10;

    explicit DeckPage(const juce::String& name) : Component(name) {}

    /// Shows the current values and repaints only changes. The window's timer calls it while the
    /// page is visible.
    virtual void refresh() = 0;

    /// Receives each new frame while the page is visible. The window takes it from the processor
    /// once for all pages.
    virtual void showSound(const SoundFrame&) {}

protected:
    /// Adds a button that runs the action and then refreshes the page.
    void addButton(juce::TextButton& button,
                   const juce::String& title,
                   const juce::String& tooltip,
                   std::function<void()> action) {
        button.setTitle(title);
        button.setTooltip(tooltip);
        button.onClick = [this, act = std::move(action)] {
            act();
            refresh();
        };
        addAndMakeVisible(button);
    }
};

} // namespace idiophone
