// The filters of the preset browser: a list of sources and a list of tags.
#pragma once

#include "Editor/Look.h"
#include "Editor/PresetSearch.h"
#include "Editor/PresetShelf.h"
#include "Editor/Utf8.h"

#include <algorithm>
#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <set>
#include <vector>

namespace idiophone {

class PresetSources final : public juce::Component {
public:
    PresetSources() {
        sourceList.onChoice = tagList.onChoice = [this] { followChoice(); };
        showParts(*this, sourceList, tagList);
    }

    std::function<void()> onChange;

    /// Lists the sources and tags of these presets. Keeps choices that still exist.
    void show(const std::vector<ShelvedPreset>& presets) {
        const juce::ScopedValueSetter<bool> filling(isFilling, true);
        std::set<juce::String> folders;
        bool hasOwn = false;
        for (const auto& preset : presets) {
            hasOwn = hasOwn || !preset.isFactory;
            if (!preset.folder.empty())
                folders.insert(fromUtf8(preset.folder));
        }
        sources = {
            {Kind::all, "All"}, {Kind::favourites, "Favourites"}, {Kind::factory, "Factory"}};
        if (hasOwn)
            sources.push_back({Kind::own, "Yours"});
        for (const auto& folder : folders)
            sources.push_back({Kind::folder, folder});
        juce::StringArray names;
        for (const auto& source : sources)
            names.add((source.kind == Kind::folder ? "   " : "") + source.name);
        sourceList.fill(names);
        const auto place = std::ranges::find(sources, chosen);
        sourceList.selectRow(
            place == sources.end() ? 0 : static_cast<int>(std::distance(sources.begin(), place)));
        chosen = sources[static_cast<std::size_t>(sourceList.getSelectedRow())];

        tags = tagsOf(presets);
        tagList.fill(tags);
        juce::SparseSet<int> rows;
        for (const auto& tag : chosenTags)
            if (const int row = tags.indexOf(tag); row >= 0)
                rows.addRange({row, row + 1});
        tagList.setSelectedRows(rows, juce::dontSendNotification);
        for (int i = chosenTags.size(); --i >= 0;)
            if (!tags.contains(chosenTags[i]))
                chosenTags.remove(i);
        resized();
    }
    /// Whether a preset belongs to the chosen source and has all chosen tags.
    bool passes(const ShelvedPreset& preset) const {
        const auto folder = fromUtf8(preset.folder);
        const bool isHere = chosen.kind == Kind::all ||
                            (chosen.kind == Kind::favourites && preset.isFavourite) ||
                            (chosen.kind == Kind::factory && preset.isFactory) ||
                            (chosen.kind == Kind::own && !preset.isFactory) ||
                            (chosen.kind == Kind::folder && !preset.isFactory &&
                             (folder == chosen.name || folder.startsWith(chosen.name + "/")));
        if (!isHere)
            return false;
        const auto own = tagsOf({preset});
        return std::all_of(chosenTags.begin(), chosenTags.end(),
                           [&](const juce::String& tag) { return own.contains(tag); });
    }
    /// Whether the choice leaves presets out.
    bool isNarrowed() const { return chosen.kind != Kind::all || !chosenTags.isEmpty(); }
    void chooseAll() {
        chosen = {Kind::all, "All"};
        chosenTags.clear();
    }

    void resized() override {
        auto area = getLocalBounds();
        const int wanted = static_cast<int>(sources.size()) * rowHeightPixels + 2;
        sourceList.setBounds(area.removeFromTop(juce::jmin(wanted, area.getHeight() / 2)));
        tagHeading = area.removeFromTop(headingHeight + 4).withTrimmedTop(4);
        tagList.setBounds(area);
    }
    void paint(juce::Graphics& g) override {
        g.setColour(colourOf(*this, LookColour::dimText));
        g.setFont(Look::headingFont());
        g.drawText("Tags", tagHeading.reduced(8, 0), juce::Justification::centredLeft, false);
    }

private:
    static constexpr int rowHeightPixels = 22, headingHeight = 22;

    enum class Kind { all, favourites, factory, own, folder };
    struct Source {
        Kind kind;
        juce::String name; ///< for a folder, its path
        bool operator==(const Source&) const = default;
    };

    /// A list of text rows for a single choice or several.
    class Choices final : public juce::ListBox, private juce::ListBoxModel {
    public:
        Choices(const juce::String& title, bool several) {
            setTitle(title);
            setModel(this);
            setRowHeight(rowHeightPixels);
            setMultipleSelectionEnabled(several);
            setClickingTogglesRowSelection(several);
            setColour(backgroundColourId, juce::Colours::transparentBlack);
        }

        std::function<void()> onChoice;

        void fill(const juce::StringArray& texts) {
            names = texts;
            updateContent();
            repaint();
        }

    private:
        int getNumRows() override { return names.size(); }
        void paintListBoxItem(
            int row, juce::Graphics& g, int width, int height, bool isSelected) override {
            const auto area = juce::Rectangle<int>(width, height).reduced(0, 1);
            if (isSelected) {
                g.setColour(colourOf(*this, LookColour::accent));
                g.fillRoundedRectangle(area.toFloat(), 4);
            }
            g.setColour(colourOf(*this, isSelected ? LookColour::onAccent : LookColour::text));
            g.setFont(Look::textFont());
            g.drawText(names[row], area.reduced(8, 0), juce::Justification::centredLeft, true);
        }
        void selectedRowsChanged(int) override { juce::NullCheckedInvocation::invoke(onChoice); }
        juce::String getNameForRow(int row) override { return names[row]; }

        juce::StringArray names;
    };

    void followChoice() {
        if (isFilling)
            return;
        const int row = sourceList.getSelectedRow();
        if (row >= 0 && row < static_cast<int>(sources.size()))
            chosen = sources[static_cast<std::size_t>(row)];
        chosenTags.clear();
        const auto rows = tagList.getSelectedRows();
        for (int i = 0; i < rows.size(); ++i)
            chosenTags.add(tags[rows[i]]);
        juce::NullCheckedInvocation::invoke(onChange);
    }

    std::vector<Source> sources;
    juce::StringArray tags;
    Source chosen{Kind::all, {}};
    juce::StringArray chosenTags;
    bool isFilling = false;
    Choices sourceList{"From", false}, tagList{"Tags", true};
    juce::Rectangle<int> tagHeading;
};

} // namespace idiophone
