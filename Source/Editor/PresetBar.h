// The top of the window: the product's name, the preset with its neighbours, and actions on the
// whole sound: favourite, save, compare, mutate, undo, redo.
#pragma once

#include "Editor/CompareSwitch.h"
#include "Editor/IconButton.h"
#include "Editor/ProcessorView.h"

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <memory>

namespace idiophone {

/// Needs at least 640 x 40 pixels.
class PresetBar final : public juce::Component {
public:
    explicit PresetBar(ProcessorView& view);
    ~PresetBar() override;

    /// Called to open the list of presets, and to ask for the name of a new preset.
    std::function<void()> onBrowse;
    std::function<void()> onSaveAs;

    void refresh();
    /// Overwrites the user's current preset. For a factory preset or none, asks for a name.
    void save();
    /// Handles the usual keys for undo, redo and save, from anywhere in the window.
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
