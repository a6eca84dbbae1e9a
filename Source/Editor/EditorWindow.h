// The plugin's window: presets on top, the picture of the instrument, the deck of pages below or
// beside it, then status and keyboard.
#pragma once

#include "Editor/ControlHost.h"
#include "Editor/ControllerList.h"
#include "Editor/DropFrame.h"
#include "Editor/FocusRing.h"
#include "Editor/IconButton.h"
#include "Editor/Icons.h"
#include "Editor/KeyboardPanel.h"
#include "Editor/Look.h"
#include "Editor/ObjectPane.h"
#include "Editor/PageDeck.h"
#include "Editor/ParameterControl.h"
#include "Editor/Preferences.h"
#include "Editor/PresetBar.h"
#include "Editor/PresetBrowser.h"
#include "Editor/ProcessorView.h"
#include "Editor/StatusBar.h"

#include <juce_audio_processors/juce_audio_processors.h>
#include <optional>

namespace idiophone {

class EditorWindow final : public juce::AudioProcessorEditor,
                           public juce::FileDragAndDropTarget,
                           public ControlHost,
                           private juce::Timer {
public:
    static constexpr int minimumWidth = 800, minimumHeight = 500;
    static constexpr int maximumWidth = 3840, maximumHeight = 2160;

    EditorWindow(juce::AudioProcessor& processor, ProcessorView& view);
    ~EditorWindow() override;

    void paint(juce::Graphics& g) override;
    void resized() override;
    bool keyPressed(const juce::KeyPress& key) override;
    bool keyStateChanged(bool isDown) override;
    void focusOfChildComponentChanged(FocusChangeType cause) override;

    /// Shows the preset browser instead of picture and pages, or hides it again.
    void setBrowsing(bool browses);

    void setLook(LookScheme scheme);

    ValueDisplay valueDisplay() const override {
        return deck.showsUnits() ? ValueDisplay::units : ValueDisplay::plain;
    }
    void showControllers() override { listControllers(true); }

    /// Accepts files that the workshop reads, scales and keyboard mappings anywhere on the window.
    /// For other files the status gives the reason. Captures dragged from this program are ignored.
    bool isInterestedInFileDrag(const juce::StringArray& files) override;
    void fileDragEnter(const juce::StringArray& files, int x, int y) override;
    void fileDragExit(const juce::StringArray& files) override;
    void filesDropped(const juce::StringArray& files, int x, int y) override;

private:
    void timerCallback() override;
    void makePages();
    void placeParts();
    void setBusy(bool busy);
    void listControllers(bool lists);

    ProcessorView& view;
    Preferences preferences;
    Look look;
    PresetBar presets;
    juce::TextButton lookButton;
    ObjectPane object;
    PageDeck deck;
    ControllerList controllers;
    PresetBrowser browser;
    StatusBar status;
    IconButton silence{"Silence", icons::silence()};
    ParameterControl volume;
    KeyboardPanel keyboard;
    DropFrame dropFrame;
    FocusRing focusRing;
    int importPage = 0, tuningPage = 0;          ///< page numbers in the deck
    std::optional<juce::TooltipWindow> tooltips; ///< only while busy: it polls
    int ticksAtRest = 0;
};

} // namespace idiophone
