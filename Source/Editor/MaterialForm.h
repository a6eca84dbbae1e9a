// The form that makes a material from the recording of a strike.
#pragma once

#include "Editor/FileButton.h"
#include "Editor/Look.h"
#include "Editor/ProcessorView.h"
#include "Editor/ReportText.h"
#include "Editor/StruckChoice.h"
#include "Editor/Utf8.h"
#include "Editor/WorkProgress.h"

#include <array>
#include <functional>

namespace idiophone {

/// Needs 360 x 270 pixels. Escape closes it; a running fit goes on.
class MaterialForm final : public juce::Component {
    using Stage = MaterialFitStatus::Stage;

public:
    explicit MaterialForm(MaterialFitView& materialFits)
        : view(materialFits), open("Open...",
                                   "Open the recording of a strike",
                                   "Open the recording of one strike (WAV, FLAC, AIFF)",
                                   fromUtf8(materialFits.recordingPatterns()),
                                   [this](const std::filesystem::path& chosen) { choose(chosen); }),
          struck(materialFits) {
        setTitle("Material from a recording");
        for (std::size_t i = 0; i < labels.size(); ++i) {
            labels[i].setText(std::array{"Recording", "Object", "Name"}[i],
                              juce::dontSendNotification);
            labels[i].setAccessible(false);
            addAndMakeVisible(labels[i]);
        }
        file.setTitle("Recording");
        name.setTitle("Name of the material");
        name.setFont(Look::textFont());
        name.setIndents(6, 0);
        name.setJustification(juce::Justification::centredLeft);
        name.setSelectAllWhenFocused(true);
        name.setInputRestrictions(60);
        name.onEscapeKey = [this] { juce::NullCheckedInvocation::invoke(onClose); };
        name.onReturnKey = [this] { make.triggerClick(); };
        make.setTitle("Make the material");
        make.setTooltip("Fit the material, save it, and hear it on this sound");
        make.onClick = [this] { start(); };
        cancel.setTitle("Cancel the fit");
        cancel.setTooltip("Stop the fit. Nothing is saved.");
        cancel.onClick = [this] {
            view.cancelFit();
            refresh();
        };
        close.setTitle("Close the form");
        close.setTooltip("Back to the material (Escape)");
        close.onClick = [this] { juce::NullCheckedInvocation::invoke(onClose); };
        step.setTitle("Progress");
        struck.onChange = [this] { showActions(); };
        showParts(*this, file, open, struck, name, make, close, step, report);
        addChildComponent(cancel);
        addChildComponent(bar);
        showStatus();
    }

    std::function<void()> onClose;

    /// Takes a recording, and names the material after it.
    void choose(const std::filesystem::path& chosen) {
        recording = chosen;
        name.setText(materialName(textOf(chosen.stem())), false);
        showStatus();
    }
    /// "glass-cup_2" becomes "Glass cup 2".
    static juce::String materialName(const juce::String& stem) {
        const auto words = stem.replaceCharacters("-_", "  ").trim();
        return words.substring(0, 1).toUpperCase() + words.substring(1);
    }

    void refresh() {
        struck.refresh();
        if (auto now = view.fitStatus(); now != shown) {
            shown = std::move(now);
            showStatus();
        }
    }

    void resized() override {
        constexpr int line = 26, gap = 5, labelWidth = 76, buttonWidth = 72;
        auto area = getLocalBounds();
        const auto row = [&](int height) {
            auto result = area.removeFromTop(height);
            area.removeFromTop(gap);
            return result;
        };
        auto first = row(line);
        labels[0].setBounds(first.removeFromLeft(labelWidth));
        open.setBounds(first.removeFromRight(buttonWidth));
        file.setBounds(first.withTrimmedRight(gap));
        auto second = row(StruckChoice::height);
        labels[1].setBounds(second.withHeight(line).removeFromLeft(labelWidth));
        struck.setBounds(second.withTrimmedLeft(labelWidth));
        auto third = row(line);
        labels[2].setBounds(third.removeFromLeft(labelWidth));
        name.setBounds(third);
        auto fourth = row(line);
        close.setBounds(fourth.removeFromRight(buttonWidth));
        fourth.removeFromRight(gap);
        make.setBounds(fourth.removeFromRight(buttonWidth));
        cancel.setBounds(make.getBounds());
        step.setBounds(fourth.withTrimmedRight(gap));
        bar.setBounds(area.removeFromTop(WorkBar::height));
        area.removeFromTop(2);
        report.setBounds(area);
    }
    void lookAndFeelChanged() override {
        for (auto* label : {&labels[0], &labels[1], &labels[2], &file})
            label->setColour(juce::Label::textColourId, colourOf(*this, LookColour::text));
        step.setColour(juce::Label::textColourId, colourOf(*this, LookColour::dimText));
        showStatus();
    }
    bool keyPressed(const juce::KeyPress& key) override {
        if (key != juce::KeyPress::escapeKey)
            return false;
        juce::NullCheckedInvocation::invoke(onClose);
        return true;
    }

private:
    static constexpr const char* purpose =
        "The recording of one strike in a quiet room tells how a material rings, and together with "
        "the object that was struck how stiff it is. The material is added to your own ones and "
        "can be put on any object.";

    void start() {
        RecordedStrike strike{.recording = recording,
                              .materialName = name.getText().trim().toStdString()};
        struck.describe(strike);
        view.fitMaterial(strike);
        refresh();
    }
    void showActions() { make.setEnabled(!recording.empty() && struck.isComplete()); }
    void showStatus() {
        const bool isWorking = shown.stage == Stage::working;
        make.setVisible(!isWorking);
        cancel.setVisible(isWorking);
        bar.setVisible(isWorking);
        bar.show(shown.progress);
        file.setText(textOf(recording.filename()), juce::dontSendNotification);
        step.setText(isWorking                         ? workText(shown.step, shown.secondsLeft)
                     : shown.stage == Stage::cancelled ? juce::String("Cancelled.")
                                                       : juce::String(),
                     juce::dontSendNotification);
        showActions();
        report.show(shown.report.empty() && !isWorking ? juce::String(purpose)
                                                       : fromUtf8(shown.report),
                    shown.stage == Stage::failed ? LookColour::error : LookColour::dimText);
    }

    MaterialFitView& view;
    MaterialFitStatus shown;
    std::filesystem::path recording;
    std::array<TextLabel, 3> labels;
    TextLabel file, step;
    FileButton open;
    StruckChoice struck;
    juce::TextEditor name;
    ReportText report{"What was found"};
    juce::TextButton make{"Make"}, cancel{"Cancel"}, close{"Back"};
    WorkBar bar;
};

} // namespace idiophone
