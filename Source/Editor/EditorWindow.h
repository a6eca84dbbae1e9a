// The plugin's window: presets on top, the picture of the instrument, the deck of pages below or
// beside it, then status and keyboard.
#pragma once

#include "Editor/ControlHint.h"
#include "Editor/ControlHost.h"
#include "Editor/ControllerList.h"
#include "Editor/DialogLook.h"
#include "Editor/DropFrame.h"
#include "Editor/FirstHints.h"
#include "Editor/FocusRing.h"
#include "Editor/IconButton.h"
#include "Editor/Icons.h"
#include "Editor/KeyboardPanel.h"
#include "Editor/Look.h"
#include "Editor/LookButton.h"
#include "Editor/ObjectPane.h"
#include "Editor/PageDeck.h"
#include "Editor/ParameterControl.h"
#include "Editor/Preferences.h"
#include "Editor/PresetBar.h"
#include "Editor/PresetBrowser.h"
#include "Editor/PresetPhrase.h"
#include "Editor/ProcessorView.h"
#include "Editor/RecorderStrip.h"
#include "Editor/SampleForm.h"
#include "Editor/StatusBar.h"
#include "Editor/WindowScale.h"

#include <juce_audio_processors/juce_audio_processors.h>

namespace idiophone {

class EditorWindow final : public juce::AudioProcessorEditor,
                           public juce::FileDragAndDropTarget,
                           public ControlHost,
                           private juce::Timer {
public:
    EditorWindow(juce::AudioProcessor& processor, ProcessorView& view);
    ~EditorWindow() override;

    void paint(juce::Graphics& g) override { g.fillAll(colourOf(*this, LookColour::background)); }
    void resized() override;
    bool keyPressed(const juce::KeyPress& key) override;
    bool keyStateChanged(bool isDown) override;
    void focusOfChildComponentChanged(FocusChangeType cause) override;
    void parentHierarchyChanged() override { colourSurroundings(); }

    /// Shows the preset browser instead of picture and pages, or hides it again.
    void setBrowsing(bool browses) { show(browses ? Middle::browser : Middle::pages); }

    void setLook(LookScheme scheme);

    /// Scales the window and all in it; a value of `ScaleButton::percents`. The size before scaling
    /// stays, unless the screen is too small for it.
    void setScale(int percent);
    /// Called by hosts for their screen. Multiplies the user's scale.
    void setScaleFactor(float ofHost) override;

    ValueDisplay valueDisplay() const override {
        return deck.showsUnits() ? ValueDisplay::units : ValueDisplay::plain;
    }
    void showControllers() override { show(Middle::controllers); }

    /// Accepts files that the workshop reads, presets, scales and keyboard mappings anywhere on the
    /// window; a file of an object over a key is for this key. For other files the status gives the
    /// reason. Captures dragged from this program are ignored.
    bool isInterestedInFileDrag(const juce::StringArray& files) override;
    void fileDragMove(const juce::StringArray& files, int x, int y) override;
    void fileDragExit(const juce::StringArray& files) override;
    void filesDropped(const juce::StringArray& files, int x, int y) override;

private:
    /// The middle of the window shows the browser, the export of samples, or the picture with pages
    /// or controllers.
    enum class Middle { pages, controllers, browser, samples };

    void show(Middle shown);
    void showPage(int page) {
        show(Middle::pages);
        deck.show(page);
    }
    void timerCallback() override;
    void makePages();
    void playPhrases();
    void placeParts();
    void setBusy(bool busy);
    void colourSurroundings();
    std::optional<int> noteAt(int x, int y) const {
        return keyboard.noteAt(keyboard.getLocalPoint(this, juce::Point(x, y)));
    }

    ProcessorView& view;
    Preferences preferences;
    Look look;
    juce::SharedResourcePointer<DialogLook> dialogs;
    PresetBar presets;
    ScaleButton scaleButton;
    LookButton lookButton;
    ObjectPane object;
    PageDeck deck;
    ControllerList controllers;
    PresetBrowser browser;
    SampleForm samples;
    StatusBar status;
    RecorderStrip recorder;
    IconButton silence{"Silence", icons::silence()};
    ParameterControl volume;
    KeyboardPanel keyboard;
    PresetPhrase phrase{view.instrument, view.stage};
    DropFrame dropFrame;
    FocusRing focusRing;
    int importPage = 0, kitPage = 0, tuningPage = 0; ///< page numbers in the deck
    ControlHint hint;
    FirstHints firstHints;
    int ticksAtRest = 0;
    WindowLimits limits{*this};
    float userScale = 1, hostScale = 1;
};

} // namespace idiophone
