// One page of the deck below or beside the instrument's picture.
#pragma once

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <utility>

namespace idiophone {

struct SoundFrame;

/// Its name is what its tab says.
class DeckPage : public juce::Component {
public:
    /// What every page must get along with.
    static constexpr int leastWidth = 380, leastHeight = 290;
    /// Wider or higher a page is not made.
    static constexpr int mostWidth = 640, mostHeight = 460;
    /// Free space around what a page shows.
    static constexpr int padding = 10;

    explicit DeckPage(const juce::String& name) : Component(name) {}

    /// Shows what holds now; repaints only what changed. Called by the window's timer while the
    /// page can be seen.
    virtual void refresh() = 0;

    /// Each frame of the sound as it is now, which the window takes from the processor once for
    /// all; while the page can be seen.
    virtual void showSound(const SoundFrame&) {}

protected:
    /// A button that acts, whereupon the page shows what holds then.
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
