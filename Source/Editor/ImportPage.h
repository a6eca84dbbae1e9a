// The page of the imported object: file, settings, progress of the analysis, its choices and their
// reasons, and how keys play it.
#pragma once

#include "Editor/DeckPage.h"
#include "Editor/FileButton.h"
#include "Editor/ImportForm.h"
#include "Editor/Look.h"
#include "Editor/ObjectShortcuts.h"
#include "Editor/ProcessorView.h"
#include "Editor/ReportText.h"
#include "Editor/Utf8.h"
#include "Editor/WorkProgress.h"

#include <utility>

namespace idiophone {

class ImportPage final : public DeckPage {
    using Stage = ImportStatus::Stage;

public:
    explicit ImportPage(ProcessorView& processor)
        : DeckPage("Object"), view(processor),
          open("Open...",
               "Open a mesh, a recording or a modal object",
               "Open a mesh (OBJ, PLY, STL, OFF, glTF), the recording of a strike (WAV, FLAC, "
               "AIFF) or a "
               "modal object. Dropping it on the window does the same.",
               fromUtf8(processor.workshop.openPatterns()),
               [this](const std::filesystem::path& chosen) {
                   view.workshop.openFile(chosen);
                   refresh();
               }),
          form(processor) {
        addButton(cancel, "Cancel the analysis", "Stop the analysis. The current sound stays.",
                  [this] { view.workshop.cancelImport(); });
        addButton(again, "Analyse anew", "Analyse the current object again with these settings",
                  [this] { view.workshop.analyseAgain(); });
        addButton(scaled, "Keys scaled to their pitches",
                  "Every key plays the object at the size that has the key's pitch",
                  [this] { view.workshop.setKeyLayout(KeyLayout::scaled); });
        addButton(zones, "Keys along a strike path",
                  "The object at its own size, struck along the path as the keys go up",
                  [this] { view.workshop.setKeyLayout(KeyLayout::zones); });
        setTextOf(keys, "Keys play it");
        shortcuts.onChosen = [this](const ObjectShortcut& shortcut) { make(shortcut); };
        file.setTitle("File");
        step.setTitle("Progress");
        measures.setTitle("Size and mass");
        showParts(*this, open, file, step, measures, shortcuts, form, keys, report);
        addChildComponent(bar);
        shown = view.workshop.importStatus();
        lookAndFeelChanged();
        showKeys();
        showActions(shown);
        showStatus();
    }

    /// Says what an import is doing; empty if nothing.
    static juce::String stepText(const ImportStatus& status) {
        const auto doing = workText(status.step, status.secondsLeft);
        switch (status.stage) {
        case Stage::working:
            return doing;
        case Stage::previewed:
            return "A preview plays. " + doing;
        case Stage::cancelled:
            return "Cancelled.";
        default:
            return {};
        }
    }

    void refresh() override {
        showKeys();
        auto status = view.workshop.importStatus();
        showActions(status);
        if (status == shown)
            return;
        shown = std::move(status);
        showStatus();
    }

    void resized() override {
        constexpr int line = 26, gap = 6;
        auto area = getLocalBounds().reduced(padding);
        auto top = area.removeFromTop(line);
        const auto last = top.removeFromRight(104);
        cancel.setBounds(last);
        again.setBounds(last);
        top.removeFromRight(gap);
        open.setBounds(top.removeFromRight(72));
        file.setBounds(top.withTrimmedRight(gap));
        area.removeFromTop(4);
        step.setBounds(area.removeFromTop(18));
        measures.setBounds(step.getBounds());
        bar.setBounds(area.removeFromTop(6).withHeight(WorkBar::height));
        shortcuts.setBounds(area.removeFromTop(24));
        area.removeFromTop(4);
        form.setBounds(area.removeFromTop(ImportForm::height));
        area.removeFromTop(4);
        auto row = area.removeFromTop(line);
        keys.setBounds(row.removeFromLeft(88));
        const int width = (row.getWidth() - gap) / 2;
        scaled.setBounds(row.removeFromLeft(width));
        zones.setBounds(row.withTrimmedLeft(gap));
        area.removeFromTop(gap);
        report.setBounds(area);
    }
    void lookAndFeelChanged() override {
        step.setColour(juce::Label::textColourId, colourOf(*this, LookColour::dimText));
        measures.setColour(juce::Label::textColourId, colourOf(*this, LookColour::text));
        keys.setColour(juce::Label::textColourId, colourOf(*this, LookColour::text));
        showStatus();
    }

private:
    static void setTextOf(juce::Label& label, const juce::String& text) {
        label.setText(text, juce::dontSendNotification);
    }

    /// Makes the object anew as the shortcut says, whether or not it came from a file.
    void make(const ObjectShortcut& shortcut) {
        const auto status = view.workshop.importStatus();
        view.workshop.setImportSettings(withShortcut(status.settings, shortcut));
        if (!status.followsSettings)
            view.workshop.analyseAgain();
        refresh();
    }
    void showActions(const ImportStatus& status) {
        const bool canAnalyse = view.workshop.canAnalyseAgain();
        again.setEnabled(canAnalyse && !status.isWorking());
        shortcuts.show(status.settings, canAnalyse);
    }
    void showKeys() {
        const auto layout = view.workshop.keyLayout();
        for (const auto& [button, own] :
             {std::pair{&scaled, KeyLayout::scaled}, std::pair{&zones, KeyLayout::zones}}) {
            button->setEnabled(layout.has_value());
            button->setToggleState(layout == own, juce::dontSendNotification);
        }
    }
    void showStatus() {
        const bool isWorking = shown.isWorking();
        setTextOf(file, shown.stage == Stage::none ? juce::String("Drop a mesh here, or")
                                                   : fromUtf8(shown.fileName));
        setTextOf(step, stepText(shown));
        setTextOf(measures, measuresText(shown.sidesMetres, shown.massKg));
        measures.setVisible(step.getText().isEmpty());
        cancel.setVisible(isWorking);
        again.setVisible(!isWorking);
        form.show(shown);
        report.show(words(),
                    shown.stage == Stage::failed ? LookColour::error : LookColour::dimText);
        bar.setVisible(isWorking);
        bar.show(shown.progress);
    }
    juce::String words() const {
        if (shown.stage == Stage::none)
            return "A mesh in OBJ, PLY, STL, OFF or glTF becomes an object that can be played: "
                   "within a "
                   "moment as a preview, then as it is. The settings above may be changed at any "
                   "time. The recording of one strike (WAV, FLAC or AIFF) becomes an object with "
                   "its modes.";
        juce::StringArray lines;
        if (shown.stage == Stage::failed)
            lines.add(fromUtf8(shown.error));
        if (!shown.summary.empty())
            lines.add(fromUtf8(shown.summary) + ".");
        if (!shown.notes.empty())
            lines.add(fromUtf8(shown.notes));
        return lines.joinIntoString("\n");
    }

    ProcessorView& view;
    ImportStatus shown;
    FileButton open;
    juce::TextButton cancel{"Cancel"}, again{"Analyse anew"};
    juce::TextButton scaled{"To their pitches"}, zones{"Along a path"};
    TextLabel file, step, measures, keys;
    ObjectShortcutRow shortcuts;
    ImportForm form;
    ReportText report{"What was made of the file"};
    WorkBar bar;
};

} // namespace idiophone
