// The preset browser over the middle of the window: search, filters, audition, and actions on
// files.
#pragma once

#include "Editor/PresetForm.h"
#include "Editor/PresetList.h"
#include "Editor/PresetSources.h"
#include "Editor/ProcessorView.h"

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

/// Arrows play each preset that they select. Return keeps the current one; Escape restores the
/// previous sound. Needs at least 640 x 300 pixels.
class PresetBrowser final : public juce::Component {
public:
    explicit PresetBrowser(PresetShelf& shelf);

    /// Called to close the browser, after a preset was kept or the old sound restored.
    std::function<void()> onClose;
    /// Called when a selected preset plays, and when the switch asks for a phrase then or not.
    std::function<void()> onSelect;
    std::function<void(bool)> onPlaySwitch;

    /// Reads the presets again and scrolls to the current one.
    void open();
    /// Shows the form that saves the current sound.
    void askToSave() { ask(Question::save); }
    /// Sets the switch for a phrase on selection.
    void setPlaysOnSelection(bool plays) {
        playSwitch.setToggleState(plays, juce::dontSendNotification);
    }

    void paint(juce::Graphics& g) override;
    void resized() override;
    bool keyPressed(const juce::KeyPress& key) override;
    void lookAndFeelChanged() override { colourStatus(); }

private:
    enum class Question { none, save, rename, remove };

    void close(bool keep);
    void refill();
    void clearFilters();
    void audition(const ShelvedPreset& preset);
    void ask(Question question);
    void answer(const PresetDetails& details);
    void showActions();
    /// Shows a sentence in the status.
    void say(const juce::String& sentence, bool isError);
    void colourStatus();
    void arrangeHint();

    /// The search field. It leaves the list's keys to the browser. It shows its hint even while
    /// focused, when JUCE would hide the hint.
    class Search final : public juce::TextEditor {
    public:
        bool keyPressed(const juce::KeyPress& key) override {
            return !movesInList(key) && TextEditor::keyPressed(key);
        }
        void paintOverChildren(juce::Graphics& g) override;
    };
    static bool movesInList(const juce::KeyPress& key);

    PresetShelf& shelf;
    PresetSources sources;
    Search search;
    PresetList list;
    PresetForm form;
    Question question = Question::none;
    std::string askedId; ///< id of the preset in question, or empty
    juce::Label status;
    bool saysError = false;
    bool saysSearch = false; ///< whether the status is about the search
    juce::ToggleButton playSwitch{"Play on selection"};
    juce::TextButton clear{"Clear"}, saveAs{"Save as..."}, rename{"Rename"}, remove{"Delete"},
        reveal{"Folder"}, init{"Init"}, back{"Back"}, keep{"Keep"};
};

} // namespace idiophone
