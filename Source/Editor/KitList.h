// The list of a kit's parts: object, keys, velocities, level and choke group in each row, and below
// them the part's own material and mallet.
#pragma once

#include "Editor/KitText.h"
#include "Editor/Look.h"

#include <algorithm>
#include <array>
#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <memory>
#include <utility>
#include <vector>

namespace idiophone {

class KitList final : public juce::ListBox, private juce::ListBoxModel {
public:
    KitList() {
        setTitle("Parts");
        setModel(this);
        setRowHeight(32);
        setColour(backgroundColourId, juce::Colours::transparentBlack);
        setHeaderComponent(std::make_unique<Header>());
    }

    /// Called when the user, not `show`, selects a part.
    std::function<void()> onSelect;
    /// Called on Delete.
    std::function<void()> onRemove;

    /// Shows these parts, one of which is selected if there are any.
    void show(std::vector<KitView::Part> parts, int row) {
        const juce::ScopedValueSetter<bool> filling(isFilling, true);
        rows = std::move(parts);
        updateContent();
        selectRow(std::clamp(row, 0, std::max(getNumRows() - 1, 0)));
        repaint();
    }

private:
    static constexpr std::array titles{"Object", "Keys", "Velocities", "Level", "Choke"};
    static constexpr std::array widths{0, 74, 68, 58, 42}; ///< the first one takes the rest

    template <class Draw>
    static void drawCells(juce::Rectangle<int> line, const Draw& draw) {
        for (std::size_t i = widths.size(); --i > 0;)
            draw(i, line.removeFromRight(widths[i]));
        draw(0, line.withTrimmedRight(6));
    }

    class Header final : public juce::Component {
    public:
        Header() {
            setSize(0, 18);
            setAccessible(false);
        }
        void paint(juce::Graphics& g) override {
            g.setColour(colourOf(*this, LookColour::dimText));
            g.setFont(Look::headingFont());
            drawCells(cellsIn(getLocalBounds()),
                      [&](std::size_t i, const juce::Rectangle<int>& cell) {
                          g.drawText(titles[i], cell, juce::Justification::centredLeft);
                      });
        }
    };

    static juce::Rectangle<int> cellsIn(const juce::Rectangle<int>& row) {
        return row.withTrimmedLeft(6).withTrimmedRight(scrollBarWidth);
    }

    int getNumRows() override { return static_cast<int>(rows.size()); }
    void
    paintListBoxItem(int row, juce::Graphics& g, int width, int height, bool isSelected) override {
        if (row >= getNumRows())
            return;
        const auto& part = rows[static_cast<std::size_t>(row)];
        const auto area = juce::Rectangle<int>(width, height).reduced(0, 1);
        if (isSelected)
            drawSelectedRow(g, area, *this);
        auto below = cellsIn({getWidth(), height}).withY(area.getY());
        below.setHeight(area.getHeight());
        const auto line = below.removeFromTop(area.getHeight() * 9 / 16);
        const std::array texts{fromUtf8(part.object), keysText(keysOf(part)), velocitiesText(part),
                               levelText(part.levelDb), chokeText(part.chokeGroup)};
        g.setColour(colourOf(*this, LookColour::text));
        g.setFont(Look::textFont());
        drawCells(line, [&](std::size_t i, const juce::Rectangle<int>& cell) {
            g.drawText(texts[i], cell, juce::Justification::centredLeft, true);
        });
        g.setColour(colourOf(*this, isSelected ? LookColour::text : LookColour::dimText));
        g.setFont(Look::textFont(11.5f));
        g.drawText(ownText(part), below, juce::Justification::centredLeft, true);
    }
    void selectedRowsChanged(int) override {
        if (!isFilling)
            juce::NullCheckedInvocation::invoke(onSelect);
    }
    void deleteKeyPressed(int) override { juce::NullCheckedInvocation::invoke(onRemove); }
    juce::String getNameForRow(int row) override {
        return row < getNumRows() ? partText(rows[static_cast<std::size_t>(row)]) : juce::String();
    }
    juce::String getTooltipForRow(int row) override { return getNameForRow(row); }

    static constexpr int scrollBarWidth = 10;

    std::vector<KitView::Part> rows;
    bool isFilling = false;
};

} // namespace idiophone
