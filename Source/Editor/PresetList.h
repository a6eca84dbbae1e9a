// The list of presets: star, picture, name, tags and description in each row.
#pragma once

#include "Editor/Icons.h"
#include "Editor/Look.h"
#include "Editor/PresetPictures.h"
#include "Editor/PresetSearch.h"
#include "Editor/Utf8.h"

#include <algorithm>
#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <string>
#include <vector>

namespace idiophone {

class PresetList final : public juce::ListBox, private juce::ListBoxModel {
public:
    PresetList() {
        setTitle("Presets");
        setModel(this);
        setRowHeight(rowHeightPixels);
        setColour(backgroundColourId, juce::Colours::transparentBlack);
    }

    /// Called when the user, not `show`, selects a row.
    std::function<void(const ShelvedPreset&)> onSelect;
    /// Called on Return or a double click.
    std::function<void()> onChoose;
    std::function<void(const ShelvedPreset&)> onStar;

    /// Shows these presets and selects the one with that id, if present.
    void show(std::vector<ShelvedPreset> presets, const std::string& selectedId) {
        const juce::ScopedValueSetter<bool> filling(isFilling, true);
        rows = std::move(presets);
        updateContent();
        const auto found = std::ranges::find(rows, selectedId, &ShelvedPreset::id);
        if (found == rows.end())
            deselectAllRows();
        else
            selectRow(static_cast<int>(std::distance(rows.begin(), found)));
        repaint();
    }
    const ShelvedPreset* selected() const { return at(getSelectedRow()); }
    /// Moves the selection by `by` rows, as the arrow keys do.
    void step(int by) {
        const auto count = static_cast<int>(rows.size());
        if (count == 0)
            return;
        const int now = getSelectedRow();
        selectRow(now < 0 ? (by > 0 ? 0 : count - 1) : std::clamp(now + by, 0, count - 1));
    }

private:
    static constexpr int rowHeightPixels = 60, starWidth = 34, textHeight = 40;
    static constexpr int pictureWidth = 78, pictureHeight = 52;

    static juce::String sentenceOn(const ShelvedPreset& preset) {
        return fromUtf8(preset.fault.empty() ? preset.description : preset.fault);
    }

    int getNumRows() override { return static_cast<int>(rows.size()); }
    void
    paintListBoxItem(int row, juce::Graphics& g, int width, int height, bool isSelected) override {
        const auto* preset = at(row);
        if (preset == nullptr)
            return;
        auto area = juce::Rectangle<int>(width, height).reduced(2, 1);
        if (isSelected)
            drawSelectedRow(g, area, *this);
        const auto star = area.removeFromLeft(starWidth).toFloat().withSizeKeepingCentre(15, 15);
        g.setColour(
            colourOf(*this, preset->isFavourite ? LookColour::accent : LookColour::outline));
        g.fillPath(
            icons::star(),
            juce::AffineTransform::scale(star.getWidth()).translated(star.getX(), star.getY()));

        const auto colour = colourOf(*this, LookColour::outline);
        pictures.draw(g,
                      area.removeFromLeft(pictureWidth)
                          .withSizeKeepingCentre(pictureWidth, pictureHeight)
                          .toFloat(),
                      *preset, colour);
        area = area.withTrimmedLeft(10).withTrimmedRight(10);
        area = area.withSizeKeepingCentre(area.getWidth(), textHeight);
        auto first = area.removeFromTop(area.getHeight() / 2 + 1);
        const auto tags = tagLine(preset->tags);
        const auto font = Look::textFont(12.5f);
        const int textWidth = juce::GlyphArrangement::getStringWidthInt(font, tags);
        const int tagWidth = juce::jmin(first.getWidth() * 2 / 5, textWidth + 8);
        g.setColour(colourOf(*this, LookColour::dimText));
        g.setFont(font);
        g.drawText(tags, first.removeFromRight(tagWidth), juce::Justification::centredRight, true);
        if (!preset->fault.empty())
            g.setColour(colourOf(*this, LookColour::error));
        g.drawText(sentenceOn(*preset), area, juce::Justification::centredLeft, true);
        g.setColour(colourOf(*this, LookColour::text));
        g.setFont(Look::headingFont(14));
        const auto place =
            preset->folder.empty() ? juce::String() : fromUtf8(preset->folder) + " / ";
        g.drawText(place + fromUtf8(preset->name), first, juce::Justification::centredLeft, true);
    }
    void listBoxItemClicked(int row, const juce::MouseEvent& event) override {
        const auto* preset = at(row);
        if (preset != nullptr && event.x < starWidth && onStar != nullptr)
            onStar(*preset);
    }
    void listBoxItemDoubleClicked(int, const juce::MouseEvent& event) override {
        if (event.x >= starWidth)
            juce::NullCheckedInvocation::invoke(onChoose);
    }
    void selectedRowsChanged(int row) override {
        repaint();
        if (const auto* preset = at(row); preset != nullptr && !isFilling && onSelect != nullptr)
            onSelect(*preset);
    }
    void returnKeyPressed(int) override { juce::NullCheckedInvocation::invoke(onChoose); }
    juce::String getNameForRow(int row) override {
        const auto* preset = at(row);
        if (preset == nullptr)
            return {};
        return fromUtf8(preset->name) + (preset->isFavourite ? ", favourite. " : ". ") +
               sentenceOn(*preset);
    }
    juce::String getTooltipForRow(int row) override {
        const auto* preset = at(row);
        if (preset == nullptr)
            return {};
        auto text = sentenceOn(*preset);
        if (preset->fault.empty() && !preset->author.empty())
            text << "\nBy " << fromUtf8(preset->author);
        if (preset->fault.empty() && !preset->tags.empty())
            text << "\nTags: " << tagLine(preset->tags);
        return text;
    }
    const ShelvedPreset* at(int row) const {
        return row >= 0 && row < static_cast<int>(rows.size())
                   ? &rows[static_cast<std::size_t>(row)]
                   : nullptr;
    }

    std::vector<ShelvedPreset> rows;
    PresetPictures pictures;
    bool isFilling = false;
};

} // namespace idiophone
