// The deck: pages side by side under their tabs. It shows the pages that fit; a click on a tab
// shows another.
#pragma once

#include "Editor/DeckPage.h"

#include <memory>
#include <vector>

namespace idiophone {

class PageDeck final : public juce::Component {
public:
    static constexpr int tabHeight = 30, gap = 8;
    static constexpr int minimumHeight = tabHeight + DeckPage::minimumHeight;

    PageDeck();
    ~PageDeck() override;

    void add(std::unique_ptr<DeckPage> page);

    /// `refresh` and `showSound` update only visible pages.
    void refresh();
    void showSound(const SoundFrame& frame);

    /// The width of a deck that shows this many pages at their minimum width.
    static int widthFor(int pages);
    int pageCount() const { return static_cast<int>(pages.size()); }
    /// Shows the page and keeps it visible at every width. Ignores page numbers that do not exist.
    void show(int page);

    void paint(juce::Graphics& g) override;
    void resized() override;

private:
    class Tab;

    void arrange();
    std::vector<int> tabWidths(int available) const;

    std::vector<std::unique_ptr<DeckPage>> pages;
    std::vector<std::unique_ptr<Tab>> tabs;
    std::vector<juce::Rectangle<int>> backs;
    int first = 0, shown = 1, chosen = 0;
};

} // namespace idiophone
