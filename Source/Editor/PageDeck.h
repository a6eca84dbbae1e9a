// The deck: pages side by side under their tabs. It shows the pages that fit; a click on a tab
// shows another.
#pragma once

#include "Editor/DeckPage.h"
#include "Editor/Look.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <vector>

namespace idiophone {

class PageDeck final : public juce::Component {
public:
    static constexpr int tabHeight = 30, gap = 8;
    static constexpr int minimumHeight = tabHeight + DeckPage::minimumHeight;

    PageDeck() {
        setTitle("Pages");
        setFocusContainerType(FocusContainerType::focusContainer);
    }

    void add(std::unique_ptr<DeckPage> page) {
        const int index = pageCount();
        auto tab = std::make_unique<Tab>(page->getName());
        tab->onClick = [this, index] { show(index); };
        addAndMakeVisible(*tab);
        addChildComponent(*page);
        tabs.push_back(std::move(tab));
        pages.push_back(std::move(page));
        arrange();
    }

    /// These two update only visible pages.
    void refresh() {
        for (auto& page : pages)
            if (page->isVisible())
                page->refresh();
    }
    void showSound(const SoundFrame& frame) {
        for (auto& page : pages)
            if (page->isVisible())
                page->showSound(frame);
    }

    /// The width of a deck that shows this many pages at their minimum width.
    static int widthFor(int count) { return count * DeckPage::minimumWidth + (count - 1) * gap; }
    int pageCount() const { return static_cast<int>(pages.size()); }
    /// Shows the page and keeps it visible at every width. Ignores page numbers that do not exist.
    void show(int page) {
        if (page < 0 || page >= pageCount())
            return;
        chosen = page;
        if (page < first || page >= first + shown)
            arrange();
    }

    void paint(juce::Graphics& g) override {
        g.setColour(colourOf(*this, LookColour::panel));
        for (const auto& back : backs)
            g.fillRoundedRectangle(back.toFloat(), 6);
    }
    void resized() override { arrange(); }

private:
    static constexpr int widestTab = 130, minimumTabGap = 8;

    /// A page's name, underlined while the page is visible.
    class Tab final : public juce::Button {
    public:
        explicit Tab(const juce::String& title) : Button(title) {
            setTitle(title + " page");
            setTooltip("Show " + title);
        }

        static juce::Font shownFont() { return Look::headingFont(13.5f); }

        int textWidth() const {
            return juce::GlyphArrangement::getStringWidthInt(shownFont(), getButtonText());
        }

        void paintButton(juce::Graphics& g, bool highlighted, bool) override {
            const bool on = getToggleState();
            g.setColour(
                colourOf(*this, on || highlighted ? LookColour::text : LookColour::dimText));
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

    void arrange() {
        if (pages.empty())
            return;
        shown = std::clamp((getWidth() + gap) / (DeckPage::minimumWidth + gap), 1, pageCount());
        first = std::clamp(first, std::max(chosen - shown + 1, 0),
                           std::min(chosen, pageCount() - shown));
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
    /// Equal widths if the longest name fits, else widths by the length of the names.
    std::vector<int> tabWidths(int available) const {
        std::vector<int> widths;
        for (const auto& tab : tabs)
            widths.push_back(tab->textWidth());
        const int longest = *std::ranges::max_element(widths);
        const int spare =
            (available - std::accumulate(widths.begin(), widths.end(), 0)) / pageCount();
        const bool fits = available / pageCount() >= longest + minimumTabGap;
        for (auto& width : widths)
            width = fits ? std::min(available / pageCount(), widestTab) : width + spare;
        return widths;
    }

    std::vector<std::unique_ptr<DeckPage>> pages;
    std::vector<std::unique_ptr<Tab>> tabs;
    std::vector<juce::Rectangle<int>> backs;
    int first = 0, shown = 1, chosen = 0;
};

} // namespace idiophone
