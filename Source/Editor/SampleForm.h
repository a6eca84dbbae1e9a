// The export of samples over the middle of the window: choices, the size before the start, progress
// and result.
#pragma once

#include "Editor/Look.h"
#include "Editor/ProcessorView.h"
#include "Editor/SampleLists.h"
#include "Editor/Utf8.h"
#include "Editor/WorkProgress.h"

#include <functional>
#include <initializer_list>
#include <juce_gui_basics/juce_gui_basics.h>
#include <memory>
#include <utility>

namespace idiophone {

/// Escape closes it. Needs at least 640 x 300 pixels.
class SampleForm final : public juce::Component {
    using Stage = SampleStatus::Stage;

public:
    explicit SampleForm(ProcessorView& processor)
        : view(processor.samples), lists(processor.instrument) {
        setTitle("Export samples");
        setFocusContainerType(FocusContainerType::keyboardFocusContainer);
        heading.setFont(Look::headingFont(16));
        heading.setBorderSize({});
        heading.setText(getTitle(), juce::dontSendNotification);
        said.setTitle("Size of the export");
        said.setFont(Look::textFont());
        said.setBorderSize({});
        said.setJustificationType(juce::Justification::topLeft);
        said.setMinimumHorizontalScale(0.8f);
        lists.onChange = [this] { refresh(); };
        const auto action = [](juce::TextButton& button, const char* tooltip, auto&& clicked) {
            button.setTitle(button.getButtonText());
            button.setTooltip(tooltip);
            button.onClick = clicked;
        };
        action(begin,
               "Choose a folder. The samples go into a new folder there, or an unfinished export "
               "goes on.",
               [this] { chooseFolder(); });
        action(stop, "Stop the export. Exporting to the same folder again goes on.",
               [this] { view.stopExport(); });
        action(reveal, "Show the folder of the samples",
               [this] { fileOf(shown.folder).revealToUser(); });
        action(close, "Close this form. A running export goes on. (Escape)",
               [this] { juce::NullCheckedInvocation::invoke(onClose); });
        int order = 0;
        for (auto* part :
             std::initializer_list<juce::Component*>{&lists, &begin, &stop, &reveal, &close})
            part->setExplicitFocusOrder(++order);
        showParts(*this, heading, lists, said, begin, close);
        addChildComponent(stop);
        addChildComponent(reveal);
        addChildComponent(bar);
        showStatus();
    }

    std::function<void()> onClose;

    void open() {
        refresh();
        if (isShowing())
            lists.grabKeyboardFocus();
    }

    /// Shows the state of the export, and asks for the size with the chosen settings.
    void refresh() {
        lists.followInstrument();
        view.estimateSamples(lists.settings());
        auto status = view.sampleStatus();
        if (status == shown)
            return;
        shown = std::move(status);
        showStatus();
    }

    /// Exports into a new folder in this one.
    void exportTo(const juce::File& parent) {
        lastParent = parent;
        view.exportSamples(lists.settings(), pathOf(parent));
        refresh();
    }

    /// Returns the sentence about a state.
    static juce::String sentenceOf(const SampleStatus& status) {
        const auto folder = textOf(status.folder);
        const auto samples = juce::String(status.samples) +
                             (status.samples == 1 ? juce::String(" sample") : " samples");
        switch (status.stage) {
        case Stage::estimating:
            return "Estimating the size...";
        case Stage::estimated:
            return samples + ", " + lengthText(status.seconds) + " of sound in all, about " +
                   sizeText(status.megabytes) + ".";
        case Stage::exporting:
            return workText(("Exporting to " + folder + ": " +
                             juce::String(juce::roundToInt(100 * status.progress)) + " %")
                                .toStdString(),
                            status.secondsLeft);
        case Stage::done:
            return samples + " are complete in " + folder + ".";
        case Stage::stopped:
            return "Stopped. Export to the same place again to make the missing samples of " +
                   folder + ".";
        case Stage::refused:
        case Stage::failed:
            return fromUtf8(status.sentence);
        default:
            return {};
        }
    }

    void paint(juce::Graphics& g) override {
        g.setColour(colourOf(*this, LookColour::panel));
        g.fillRoundedRectangle(getLocalBounds().toFloat(), 6);
    }
    void resized() override {
        constexpr int padding = 14, row = 28, gap = 6, width = 760, height = 312;
        auto area = getLocalBounds().reduced(padding);
        area = area.withSizeKeepingCentre(juce::jmin(area.getWidth(), width),
                                          juce::jmin(area.getHeight(), height));
        heading.setBounds(area.removeFromTop(row));
        area.removeFromTop(gap);
        lists.setBounds(area.removeFromTop(SampleLists::height));
        area.removeFromTop(2 * gap);
        said.setBounds(area.removeFromTop(2 * 17));
        bar.setBounds(area.removeFromTop(WorkBar::height));
        area.removeFromTop(gap);
        auto buttons = area.removeFromTop(row);
        close.setBounds(buttons.removeFromRight(72));
        buttons.removeFromRight(gap);
        begin.setBounds(buttons.removeFromRight(96));
        stop.setBounds(begin.getBounds());
        buttons.removeFromRight(gap);
        reveal.setBounds(buttons.removeFromRight(104));
    }
    bool keyPressed(const juce::KeyPress& key) override {
        if (key != juce::KeyPress::escapeKey)
            return false;
        juce::NullCheckedInvocation::invoke(onClose);
        return true;
    }
    void lookAndFeelChanged() override {
        heading.setColour(juce::Label::textColourId, colourOf(*this, LookColour::text));
        colourSentence();
    }

private:
    static juce::String lengthText(double seconds) {
        return seconds < 90 ? juce::String(juce::jmax(1, juce::roundToInt(seconds))) + " s"
                            : juce::String(juce::roundToInt(seconds / 60)) + " min";
    }
    static juce::String sizeText(double megabytes) {
        return megabytes < 10     ? juce::String(juce::jmax(megabytes, 0.1), 1) + " MB"
               : megabytes < 1000 ? juce::String(juce::roundToInt(megabytes)) + " MB"
                                  : juce::String(megabytes / 1000, 1) + " GB";
    }

    void chooseFolder() {
        chooser = std::make_unique<juce::FileChooser>("Folder for the samples", lastParent);
        chooser->launchAsync(juce::FileBrowserComponent::openMode |
                                 juce::FileBrowserComponent::canSelectDirectories,
                             [this](const juce::FileChooser& done) {
                                 if (const auto folder = done.getResult(); folder != juce::File())
                                     exportTo(folder);
                             });
    }
    void showStatus() {
        const auto sentence = sentenceOf(shown);
        if (shown.stage == Stage::done) // the status line announces errors
            juce::AccessibilityHandler::postAnnouncement(
                sentence, juce::AccessibilityHandler::AnnouncementPriority::medium);
        said.setText(sentence, juce::dontSendNotification);
        said.setTooltip(sentence);
        colourSentence();
        const bool runs = shown.isExporting();
        const bool isFocused = begin.hasKeyboardFocus(false) || stop.hasKeyboardFocus(false);
        lists.setEnabled(!runs);
        begin.setVisible(!runs);
        begin.setEnabled(shown.stage != Stage::refused && shown.stage != Stage::none);
        stop.setVisible(runs);
        bar.setVisible(runs);
        bar.show(shown.progress);
        if (isFocused)
            (runs ? stop : begin).grabKeyboardFocus();
        reveal.setVisible(shown.stage == Stage::done);
        repaint();
    }
    void colourSentence() {
        const bool isError = shown.stage == Stage::refused || shown.stage == Stage::failed;
        said.setColour(juce::Label::textColourId,
                       colourOf(*this, isError ? LookColour::error : LookColour::text));
    }

    SampleView& view;
    SampleStatus shown;
    juce::Label heading, said;
    SampleLists lists;
    juce::TextButton begin{"Export..."}, stop{"Stop"}, reveal{"Show folder"}, close{"Close"};
    WorkBar bar;
    juce::File lastParent = juce::File::getSpecialLocation(juce::File::userMusicDirectory);
    std::unique_ptr<juce::FileChooser> chooser;
};

} // namespace idiophone
