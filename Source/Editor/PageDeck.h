// The deck: the first page, and beside it the others in sheets of as many as fit. A click on a tab
// shows the page's sheet, in which every page has its own place. In a narrow deck the tabs stand in
// two rows, and the chosen tab is the page's title.
#pragma once

#include "Editor/DeckPage.h"
#include "Editor/Look.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace idiophone {

class PageDeck final : public juce::Component {
public:
    static constexpr int tabHeight = 30, titleHeight = 22, gap = 8;
    static constexpr int aboveHeight = tabHeight + titleHeight; ///< of tabs and title
    static constexpr int minimumHeight = aboveHeight + DeckPage::minimumHeight;

    PageDeck() {
        setTitle("Pages");
        setFocusContainerType(FocusContainerType::focusContainer);
        units.setTitle("Units");
        units.setTooltip("Show figures of physics with their units, or from 0 to 100");
        units.setClickingTogglesState(true);
        units.onClick = [this] {
            juce::NullCheckedInvocation::invoke(onUnits);
            refresh();
        };
        addAndMakeVisible(units);
    }

    /// Called when the user switches the units of figures on or off.
    std::function<void()> onUnits;
    bool showsUnits() const { return units.getToggleState(); }
    void setShowsUnits(bool shows) { units.setToggleState(shows, juce::dontSendNotification); }

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
        if (!pages[static_cast<std::size_t>(page)]->isVisible())
            arrange();
    }

    void paint(juce::Graphics& g) override {
        g.setColour(colourOf(*this, LookColour::panel));
        for (const auto& [page, back] : backs)
            g.fillRoundedRectangle(back.toFloat(), 6);
        g.setColour(colourOf(*this, LookColour::text));
        g.setFont(Look::headingFont(14.5f));
        for (const auto& [page, back] : backs)
            g.drawText(hasTwoRows ? juce::String() : page->getName(),
                       back.withHeight(titleHeight + 6).reduced(DeckPage::padding, 0),
                       juce::Justification::centredLeft);
    }
    void resized() override { arrange(); }

private:
    static constexpr int widestTab = 130, minimumTabGap = 14;
    static constexpr int unitsWidth = 54, narrowUnitsWidth = 44;

    /// A page's name, underlined while the page is visible.
    class Tab final : public juce::Button {
    public:
        explicit Tab(const juce::String& title) : Button(title) {
            setTitle(title + " page");
            setTooltip("Show the " + title + " page");
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
        const int slots =
            std::clamp((getWidth() + gap) / (DeckPage::minimumWidth + gap), 1, pageCount());
        const int sheetSize = std::max(slots - 1, 1);
        if (chosen > 0)
            sheet = (chosen - 1) / sheetSize;
        // The place of a page, or −1 if it is hidden.
        const auto slotOf = [&](int page) {
            if (slots == 1)
                return page == chosen ? 0 : -1;
            if (page == 0)
                return 0;
            return (page - 1) / sheetSize == sheet ? 1 + (page - 1) % sheetSize : -1;
        };
        auto area = getLocalBounds();
        const auto tabPlaces = placeTabs(area);
        const int width = (area.getWidth() - (slots - 1) * gap) / slots;
        backs.clear();
        for (int i = 0; i < pageCount(); ++i) {
            const auto index = static_cast<std::size_t>(i);
            const int slot = slotOf(i);
            const bool visible = slot >= 0;
            tabs[index]->setBounds(tabPlaces[index]);
            tabs[index]->setToggleState(visible, juce::dontSendNotification);
            pages[index]->setVisible(visible);
            if (!visible)
                continue;
            const auto back = area.withX(area.getX() + slot * (width + gap)).withWidth(width);
            backs.push_back({pages[index].get(), back});
            const auto below = back.withTrimmedTop(hasTwoRows ? 0 : titleHeight);
            pages[index]->setBounds(below.withSizeKeepingCentre(
                std::min(width, DeckPage::maximumWidth), below.getHeight()));
            pages[index]->refresh();
        }
        const auto& last = tabPlaces.back();
        const auto beside = last.withLeft(last.getRight()).withRight(getWidth());
        units.setBounds(hasTwoRows
                            ? beside.withSizeKeepingCentre(narrowUnitsWidth, beside.getHeight())
                            : backs.back()
                                  .second.withHeight(titleHeight)
                                  .reduced(DeckPage::padding, 2)
                                  .removeFromRight(unitsWidth));
        repaint();
    }
    /// Removes the tabs from the top of the area, and returns their places.
    std::vector<juce::Rectangle<int>> placeTabs(juce::Rectangle<int>& area) {
        std::vector<juce::Rectangle<int>> places;
        const auto widths = tabWidths(area.getWidth());
        hasTwoRows = widths.empty();
        if (!hasTwoRows) {
            auto strip = area.removeFromTop(tabHeight);
            for (const int width : widths)
                places.push_back(strip.removeFromLeft(width));
            return places;
        }
        const auto strip = area.removeFromTop(aboveHeight).withTrimmedBottom(4);
        const auto upper = (tabs.size() + 1) / 2; // the switch of the units is in the lower row
        auto left = std::span(tabs);
        for (const bool isUpper : {true, false}) {
            const auto row = left.first(isUpper ? upper : left.size());
            left = left.subspan(row.size());
            const int text =
                std::accumulate(row.begin(), row.end(), isUpper ? 0 : narrowUnitsWidth,
                                [](int sum, const auto& tab) { return sum + tab->textWidth(); });
            const int spare =
                (strip.getWidth() - text) / static_cast<int>(row.size() + (isUpper ? 0 : 1));
            auto line = strip.withHeight(strip.getHeight() / 2);
            if (!isUpper)
                line.setY(line.getBottom());
            for (const auto& tab : row)
                places.push_back(line.removeFromLeft(tab->textWidth() + spare));
        }
        return places;
    }
    /// Equal widths if the longest name fits, else widths by the length of the names; empty if they
    /// do not fit in one row.
    std::vector<int> tabWidths(int available) const {
        std::vector<int> widths;
        for (const auto& tab : tabs)
            widths.push_back(tab->textWidth());
        const int longest = *std::ranges::max_element(widths);
        const int spare =
            (available - std::accumulate(widths.begin(), widths.end(), 0)) / pageCount();
        const bool fits = available / pageCount() >= longest + minimumTabGap;
        if (!fits && spare < minimumTabGap)
            return {};
        for (auto& width : widths)
            width = fits ? std::min(available / pageCount(), widestTab) : width + spare;
        return widths;
    }

    juce::TextButton units{"Units"};
    std::vector<std::unique_ptr<DeckPage>> pages;
    std::vector<std::unique_ptr<Tab>> tabs;
    std::vector<std::pair<DeckPage*, juce::Rectangle<int>>> backs; ///< of the visible pages
    bool hasTwoRows = false; ///< of tabs; then pages have no titles
    int chosen = 0;
    int sheet = 0; ///< the last one shown beside the first page
};

} // namespace idiophone
