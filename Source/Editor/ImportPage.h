// The page of the imported object: file, settings, progress of the analysis, its choices and their
// reasons, and how keys play it.
#pragma once

#include "Editor/DeckPage.h"
#include "Editor/FileButton.h"
#include "Editor/ImportForm.h"
#include "Editor/ProcessorView.h"

namespace idiophone {

class ImportPage final : public DeckPage {
public:
    explicit ImportPage(ProcessorView& view);

    void refresh() override;

    void paint(juce::Graphics& g) override;
    void resized() override;
    void lookAndFeelChanged() override;

private:
    void showKeys();
    void showStatus();
    juce::String words() const;

    ProcessorView& view;
    ImportStatus shown;
    FileButton open;
    juce::TextButton cancel{"Cancel"}, again{"Analyse anew"};
    juce::TextButton scaled{"To their pitches"}, zones{"Along a path"};
    juce::Label file, step, keys;
    ImportForm form;
    juce::TextEditor report;
    juce::Rectangle<int> bar;
};

} // namespace idiophone
