// Where presets come from and how they are tagged: two lists that narrow the list of presets.
#pragma once

#include "Editor/PresetShelf.h"

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <vector>

namespace idiophone {

class PresetSources final : public juce::Component {
public:
    PresetSources();

    /// Something was chosen.
    std::function<void()> onChange;

    /// What there is to choose from; choices stay where they are still there.
    void show(const std::vector<ShelvedPreset>& presets);
    /// Whether a preset is of the chosen source and has all chosen tags.
    bool passes(const ShelvedPreset& preset) const;
    void chooseAll();

    void resized() override;
    void paint(juce::Graphics& g) override;

private:
    enum class Kind { all, favourites, factory, own, folder };
    struct Source {
        Kind kind;
        juce::String name; ///< of a folder its path
        bool operator==(const Source&) const = default;
    };

    /// Rows of text, one or several of them chosen.
    class Choices final : public juce::ListBox, private juce::ListBoxModel {
    public:
        Choices(const juce::String& title, bool several);
        void fill(const juce::StringArray& texts);
        std::function<void()> onChoice;

    private:
        int getNumRows() override { return names.size(); }
        void paintListBoxItem(
            int row, juce::Graphics& g, int width, int height, bool isSelected) override;
        void selectedRowsChanged(int) override;
        juce::String getNameForRow(int row) override { return names[row]; }

        juce::StringArray names;
    };

    void followChoice();

    std::vector<Source> sources;
    juce::StringArray tags;
    Source chosen{Kind::all, {}};
    juce::StringArray chosenTags;
    bool isFilling = false;
    Choices sourceList{"From", false}, tagList{"Tags", true};
    juce::Rectangle<int> tagHeading;
};

} // namespace idiophone
