#include "Editor/PageDeck.h"

#include "Editor/Look.h"

#include <algorithm>
#include <numeric>

namespace idiophone {
namespace {

constexpr int widestTab = 130, minimumTabGap = 8;

} // namespace

/// A page's name, underlined while the page is visible.
class PageDeck::Tab final : public juce::Button {
public:
    explicit Tab(const juce::String& title) : Button(title) {
        setTitle(title + " page");
        setTooltip("Show " + title);
        setClickingTogglesState(false);
    }

    static juce::Font shownFont() { return Look::headingFont(13.5f); }

    int textWidth() const {
        return juce::GlyphArrangement::getStringWidthInt(shownFont(), getButtonText());
    }

    void paintButton(juce::Graphics& g, bool highlighted, bool) override {
        const bool on = getToggleState();
        g.setColour(colourOf(*this, on || highlighted ? LookColour::text : LookColour::dimText));
        g.setFont(on ? shownFont() : Look::textFont());
        auto area = getLocalBounds();
        const auto line = area.removeFromBottom(4).reduced(8, 1);
        g.drawFittedText(getButtonText(), area, juce::Justification::centred, 1, 0.8f);
        if (on || hasKeyboardFocus(false)) {
            g.setColour(colourOf(*this, on ? LookColour::accent : LookColour::outline));
            g.fillRect(line);
        }
    }
};

PageDeck::~PageDeck() = default;

/// Equal widths if the longest name fits, else widths by the length of the names.
std::vector<int> PageDeck::tabWidths(int available) const {
    std::vector<int> widths;
    for (const auto& tab : tabs)
        widths.push_back(tab->textWidth());
    const int longest = *std::ranges::max_element(widths);
    const int spare = (available - std::accumulate(widths.begin(), widths.end(), 0)) / pageCount();
    const bool fits = available / pageCount() >= longest + minimumTabGap;
    for (auto& width : widths)
        width = fits ? std::min(available / pageCount(), widestTab) : width + spare;
    return widths;
}

PageDeck::PageDeck() {
    setTitle("Pages");
    setFocusContainerType(FocusContainerType::focusContainer);
}

void PageDeck::add(std::unique_ptr<DeckPage> page) {
    const int index = pageCount();
    auto tab = std::make_unique<Tab>(page->getName());
    tab->onClick = [this, index] { show(index); };
    addAndMakeVisible(*tab);
    addChildComponent(*page);
    tabs.push_back(std::move(tab));
    pages.push_back(std::move(page));
    arrange();
}

void PageDeck::refresh() {
    for (auto& page : pages)
        if (page->isVisible())
            page->refresh();
}

void PageDeck::showSound(const SoundFrame& frame) {
    for (auto& page : pages)
        if (page->isVisible())
            page->showSound(frame);
}

int PageDeck::widthFor(int count) {
    return count * DeckPage::minimumWidth + (count - 1) * gap;
}

void PageDeck::show(int page) {
    if (page < 0 || page >= pageCount())
        return;
    chosen = page;
    if (page < first || page >= first + shown)
        arrange();
}

void PageDeck::resized() {
    arrange();
}

void PageDeck::arrange() {
    if (pages.empty())
        return;
    shown = std::clamp((getWidth() + gap) / (DeckPage::minimumWidth + gap), 1, pageCount());
    first =
        std::clamp(first, std::max(chosen - shown + 1, 0), std::min(chosen, pageCount() - shown));
    auto area = getLocalBounds();
    auto strip = area.removeFromTop(tabHeight);
    const auto widths = tabWidths(strip.getWidth());
    const int width = (area.getWidth() - (shown - 1) * gap) / shown;
    backs.clear();
    for (int i = 0; i < pageCount(); ++i) {
        const auto index = static_cast<std::size_t>(i);
        const bool visible = i >= first && i < first + shown;
        tabs[index]->setBounds(strip.removeFromLeft(widths[index]));
        tabs[index]->setToggleState(visible, juce::dontSendNotification);
        pages[index]->setVisible(visible);
        if (!visible)
            continue;
        backs.push_back(area.withX(area.getX() + (i - first) * (width + gap)).withWidth(width));
        pages[index]->setBounds(backs.back().withSizeKeepingCentre(
            std::min(width, DeckPage::maximumWidth), backs.back().getHeight()));
        pages[index]->refresh();
    }
    repaint();
}

void PageDeck::paint(juce::Graphics& g) {
    g.setColour(colourOf(*this, LookColour::panel));
    for (const auto& back : backs)
        g.fillRoundedRectangle(back.toFloat(), 6);
}

} // namespace idiophone
