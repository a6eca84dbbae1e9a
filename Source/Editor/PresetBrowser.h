// The list of presets over the middle of the window: search, filters, audition, and what is done
// with the files.
#pragma once

#include "Editor/PresetForm.h"
#include "Editor/PresetList.h"
#include "Editor/PresetSources.h"
#include "Editor/ProcessorView.h"

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

/// Arrows play presets as they go over them; Return keeps the one that plays, Escape goes back to
/// what played before. Whole from 640 x 300 pixels on.
class PresetBrowser final : public juce::Component {
public:
    explicit PresetBrowser(PresetShelf& shelf);

    /// It wants to be gone; what plays is settled.
    std::function<void()> onClose;

    /// Reads the presets anew and has the preset that plays in sight.
    void open();
    /// The same, with the form to save what plays.
    void openToSave();
    /// Settles what plays as if kept, without asking to be closed.
    void settle();

    void paint(juce::Graphics& g) override;
    void resized() override;
    bool keyPressed(const juce::KeyPress& key) override;

private:
    enum class Question { none, save, rename, remove };

    void close(bool keep);
    void refill();
    void audition(const ShelvedPreset& preset);
    void ask(Question question);
    void answer(const PresetDetails& details);
    void showActions();
    void say(const juce::String& sentence, bool isError);
    void arrangeHint();
    const ShelvedPreset* selected() const;

    /// Leaves to the browser the keys that go through the list. It has the focus from the start, in
    /// which a text editor hides its hint.
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
    std::string askedId; ///< of the preset that the question is about; empty where there is none
    juce::Label status;
    juce::TextButton saveAs{"Save as..."}, rename{"Rename"}, remove{"Delete"}, reveal{"Folder"},
        init{"Init"}, back{"Back"}, keep{"Keep"};
};

} // namespace idiophone
