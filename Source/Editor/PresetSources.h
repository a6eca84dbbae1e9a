// The filters of the preset browser: a list of sources and a list of tags.
#pragma once

#include "Editor/PresetShelf.h"

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <vector>

namespace idiophone {

class PresetSources final : public juce::Component {
public:
    PresetSources();

    std::function<void()> onChange;

    /// Lists the sources and tags of these presets. Keeps choices that still exist.
    void show(const std::vector<ShelvedPreset>& presets);
    /// Whether a preset belongs to the chosen source and has all chosen tags.
    bool passes(const ShelvedPreset& preset) const;
    void chooseAll();

    void resized() override;
    void paint(juce::Graphics& g) override;

private:
    enum class Kind { all, favourites, factory, own, folder };
    struct Source {
        Kind kind;
        juce::String name; ///< for a folder, its path
        bool operator==(const Source&) const = default;
    };

    /// A list of text rows for a single choice or several.
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
