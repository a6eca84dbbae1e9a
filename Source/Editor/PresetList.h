// Presets as rows: a star, the name, tags, and what is said of them.
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

    /// A row was selected by hand.
    std::function<void(const ShelvedPreset&)> onSelect;
    /// Chosen for good: Return or a double click.
    std::function<void()> onChoose;
    std::function<void(const ShelvedPreset&)> onStar;

    /// Shows these, with the one of that id selected if it is among them.
    void show(std::vector<ShelvedPreset> presets, const std::string& selectedId);
    const ShelvedPreset* selected() const;
    /// Selects a neighbour, as arrows do.
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
