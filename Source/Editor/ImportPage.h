// The page of what was dropped or opened: its file and settings, how far its analysis is, what was
// chosen and why, and how the keys play it.
#pragma once

#include "Editor/DeckPage.h"
#include "Editor/ImportForm.h"
#include "Editor/ProcessorView.h"

#include <memory>

namespace idiophone {

class ImportPage final : public DeckPage {
public:
    explicit ImportPage(ProcessorView& view);

    void refresh() override;

    void paint(juce::Graphics& g) override;
    void resized() override;
    void lookAndFeelChanged() override;

private:
    void addButton(juce::TextButton& button,
                   const juce::String& title,
                   const juce::String& tooltip,
                   std::function<void()> action);
    void chooseFile();
    void showKeys();
    void showStatus();
    juce::String words() const;

    ProcessorView& view;
    ImportStatus shown;
    juce::TextButton open{"Open..."}, cancel{"Cancel"}, again{"Analyse anew"};
    juce::TextButton scaled{"To their pitches"}, zones{"Along a path"};
    juce::Label file, step, keys;
    ImportForm form;
    juce::TextEditor report;
    juce::Rectangle<int> bar;
    std::unique_ptr<juce::FileChooser> chooser;
};

} // namespace idiophone
