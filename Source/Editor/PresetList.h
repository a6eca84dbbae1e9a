// The list of presets: star, name, tags and description in each row.
#pragma once

#include "Editor/PresetShelf.h"

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <string>
#include <vector>

namespace idiophone {

class PresetList final : public juce::ListBox, private juce::ListBoxModel {
public:
    PresetList();

    /// Called when the user, not `show`, selects a row.
    std::function<void(const ShelvedPreset&)> onSelect;
    /// Called on Return or a double click.
    std::function<void()> onChoose;
    std::function<void(const ShelvedPreset&)> onStar;

    /// Shows these presets and selects the one with that id, if present.
    void show(std::vector<ShelvedPreset> presets, const std::string& selectedId);
    const ShelvedPreset* selected() const;
    /// Moves the selection by `by` rows, as the arrow keys do.
    void step(int by);

private:
    int getNumRows() override { return static_cast<int>(rows.size()); }
    void
    paintListBoxItem(int row, juce::Graphics& g, int width, int height, bool isSelected) override;
    void listBoxItemClicked(int row, const juce::MouseEvent& event) override;
    void listBoxItemDoubleClicked(int row, const juce::MouseEvent& event) override;
    void selectedRowsChanged(int row) override;
    void returnKeyPressed(int row) override;
    juce::String getNameForRow(int row) override;
    juce::String getTooltipForRow(int row) override;
    const ShelvedPreset* at(int row) const;

    std::vector<ShelvedPreset> rows;
    bool isFilling = false;
};

} // namespace idiophone
