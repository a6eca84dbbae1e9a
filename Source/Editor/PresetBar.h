// The head of the window: the product's name, the preset with its neighbours one click away, and
// what is done with whole sounds: favourite, save, compare, mutate, undo, redo.
#pragma once

#include "Editor/CompareSwitch.h"
#include "Editor/IconButton.h"
#include "Editor/ProcessorView.h"

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <memory>

namespace idiophone {

/// Whole from 640 x 40 pixels on.
class PresetBar final : public juce::Component {
public:
    explicit PresetBar(ProcessorView& view);
    ~PresetBar() override;

    /// What the name and the save button ask for: the list of presets, and a name for a new one.
    std::function<void()> onBrowse;
    std::function<void()> onSaveAs;

    void refresh();
    /// Saves over the user's preset that plays, or asks for a name where there is none.
    void save();
    /// Undo, redo and save by their usual keys, from wherever in the window.
    bool handleKey(const juce::KeyPress& key);

    void paint(juce::Graphics& g) override;
    void resized() override;

private:
    class NameButton;

    void step(int by);
    void toggleFavourite();
    void mutate(double strength);
    void showMutationMenu();
    void refreshPreset();
    void refreshHistory();
    const ShelvedPreset* chosen() const;
    void report(const Result<void>& outcome);

    ProcessorView& view;
    std::unique_ptr<NameButton> name;
    IconButton previous, next, favourite, saving, mutation, copying, undo, redo;
    CompareSwitch compare;
    juce::Rectangle<int> logo;
};

} // namespace idiophone
