#include "Editor/PresetList.h"

#include "Editor/Icons.h"
#include "Editor/Look.h"
#include "Editor/Utf8.h"

#include <algorithm>

namespace idiophone {
namespace {

constexpr int rowHeightPixels = 42, starWidth = 34;

juce::String tagLine(const ShelvedPreset& preset) {
    juce::StringArray tags;
    for (const auto& tag : preset.tags)
        tags.add(fromUtf8(tag));
    return tags.joinIntoString(", ");
}

} // namespace

PresetList::PresetList() {
    setTitle("Presets");
    setModel(this);
    setRowHeight(rowHeightPixels);
    setColour(backgroundColourId, juce::Colours::transparentBlack);
}

void PresetList::show(std::vector<ShelvedPreset> presets, const std::string& selectedId) {
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

const ShelvedPreset* PresetList::at(int row) const {
    return row >= 0 && row < static_cast<int>(rows.size()) ? &rows[static_cast<std::size_t>(row)]
                                                           : nullptr;
}

const ShelvedPreset* PresetList::selected() const {
    return at(getSelectedRow());
}

void PresetList::step(int by) {
    const auto count = static_cast<int>(rows.size());
    if (count == 0)
        return;
    const int now = getSelectedRow();
    selectRow(now < 0 ? (by > 0 ? 0 : count - 1) : std::clamp(now + by, 0, count - 1));
}

void PresetList::paintListBoxItem(
    int row, juce::Graphics& g, int width, int height, bool isSelected) {
    const auto* preset = at(row);
    if (preset == nullptr)
        return;
    auto area = juce::Rectangle<int>(width, height).reduced(2, 1);
    if (isSelected) {
        g.setColour(colourOf(*this, LookColour::outline).withMultipliedAlpha(0.7f));
        g.fillRoundedRectangle(area.toFloat(), 4);
        if (hasKeyboardFocus(true)) {
            g.setColour(colourOf(*this, LookColour::accent));
            g.drawRoundedRectangle(area.toFloat().reduced(0.75f), 4, 1.5f);
        }
    }
    const auto star = area.removeFromLeft(starWidth).toFloat().withSizeKeepingCentre(15, 15);
    g.setColour(colourOf(*this, preset->isFavourite ? LookColour::accent : LookColour::outline));
    g.fillPath(icons::star(),
               juce::AffineTransform::scale(star.getWidth()).translated(star.getX(), star.getY()));

    area.removeFromRight(10);
    auto first = area.removeFromTop(area.getHeight() / 2 + 1);
    const auto tags = tagLine(*preset);
    const auto tagWidth = juce::jmin(
        first.getWidth() * 2 / 5,
        juce::roundToInt(juce::GlyphArrangement::getStringWidth(Look::textFont(12.5f), tags)) + 8);
    g.setColour(colourOf(*this, LookColour::dimText));
    g.setFont(Look::textFont(12.5f));
    g.drawText(tags, first.removeFromRight(tagWidth), juce::Justification::centredRight, true);
    g.drawText(fromUtf8(preset->fault.empty() ? preset->description : std::string()), area,
               juce::Justification::centredLeft, true);
    if (!preset->fault.empty()) {
        g.setColour(colourOf(*this, LookColour::error));
        g.drawText(fromUtf8(preset->fault), area, juce::Justification::centredLeft, true);
    }
    g.setColour(colourOf(*this, LookColour::text));
    g.setFont(Look::headingFont(14));
    const auto place = preset->folder.empty() ? juce::String() : fromUtf8(preset->folder) + " / ";
    g.drawText(place + fromUtf8(preset->name), first, juce::Justification::centredLeft, true);
}

void PresetList::listBoxItemClicked(int row, const juce::MouseEvent& event) {
    const auto* preset = at(row);
    if (preset != nullptr && event.x < starWidth && onStar != nullptr)
        onStar(*preset);
}

void PresetList::listBoxItemDoubleClicked(int, const juce::MouseEvent& event) {
    if (event.x >= starWidth)
        juce::NullCheckedInvocation::invoke(onChoose);
}

void PresetList::selectedRowsChanged(int row) {
    repaint();
    if (const auto* preset = at(row); preset != nullptr && !isFilling && onSelect != nullptr)
        onSelect(*preset);
}

void PresetList::returnKeyPressed(int) {
    juce::NullCheckedInvocation::invoke(onChoose);
}

juce::String PresetList::getNameForRow(int row) {
    const auto* preset = at(row);
    if (preset == nullptr)
        return {};
    return fromUtf8(preset->name) + (preset->isFavourite ? ", favourite" : "") +
           (preset->fault.empty() ? ". " + fromUtf8(preset->description)
                                  : ". " + fromUtf8(preset->fault));
}

juce::String PresetList::getTooltipForRow(int row) {
    const auto* preset = at(row);
    if (preset == nullptr)
        return {};
    if (!preset->fault.empty())
        return fromUtf8(preset->fault);
    const auto by = preset->author.empty() ? juce::String() : "\nBy " + fromUtf8(preset->author);
    const auto tags = preset->tags.empty() ? juce::String() : "\nTags: " + tagLine(*preset);
    return fromUtf8(preset->description) + by + tags;
}

} // namespace idiophone
