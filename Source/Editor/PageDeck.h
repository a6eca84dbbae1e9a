// Pages side by side under their tabs: as many as there is room for, the others a click away.
#pragma once

#include "Editor/DeckPage.h"

#include <memory>
#include <vector>

namespace idiophone {

class PageDeck final : public juce::Component {
public:
    static constexpr int tabHeight = 30, gap = 8;
    static constexpr int leastHeight = tabHeight + DeckPage::leastHeight;

    PageDeck();
    ~PageDeck() override;

    /// Behind those there are.
    void add(std::unique_ptr<DeckPage> page);

    /// The pages that can be seen.
    void refresh();
    void showSound(const SoundFrame& frame);

    /// How wide the deck is that shows this many pages, at their least.
    static int widthFor(int pages);
    int pageCount() const { return static_cast<int>(pages.size()); }
    /// Brings the page in sight, where it stays at every width. What does not exist is ignored.
    void show(int page);

    void paint(juce::Graphics& g) override;
    void resized() override;

private:
    class Tab;

    void arrange();
    std::vector<int> tabWidths(int room) const;

    std::vector<std::unique_ptr<DeckPage>> pages;
    std::vector<std::unique_ptr<Tab>> tabs;
    std::vector<juce::Rectangle<int>> backs;
    int first = 0, shown = 1, chosen = 0;
};

} // namespace idiophone
