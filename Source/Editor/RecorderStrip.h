// The sound as files: buttons for samples, for the last seconds and for recordings of any length.
#pragma once

#include "Editor/CaptureButton.h"
#include "Editor/IconButton.h"
#include "Editor/Icons.h"
#include "Editor/Look.h"
#include "Editor/ProcessorView.h"

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

class RecorderStrip final : public juce::Component {
public:
    explicit RecorderStrip(ProcessorView& processor)
        : view(processor.recorder), exporting(processor.samples),
          last(processor.status,
               soundCapture(processor.recorder),
               "Last 30 seconds",
               icons::soundFile()) {
        view.keepLastSound();
        last.describe(
            "Last 30 seconds",
            "The last 30 seconds as a WAV file. Drag it into the host, or click to save.");
        record.setActiveColour(LookColour::error);
        record.onClick = [this] {
            view.recording().isRunning ? view.stopRecording() : view.startRecording();
            refresh();
        };
        take.setTitle("Recording");
        take.fileToDrag = [this] { return complete(); };
        take.onClick = [this] {
            if (const auto file = complete(); file != juce::File())
                file.revealToUser();
        };
        samples.onClick = [this] { juce::NullCheckedInvocation::invoke(onSamples); };
        showParts(*this, samples, last, record);
        addChildComponent(take);
        refresh();
    }

    /// Called to open the export of samples, or to close it.
    std::function<void()> onSamples;
    /// Called when `width` has changed.
    std::function<void()> onWidth;

    /// The width that it needs, in pixels.
    int width() const { return 3 * button + gap + (take.isVisible() ? takeWidth : 0); }

    /// Shows the state of a recording: while it runs its time, then also the file.
    void refresh() {
        refreshExport();
        const auto now = view.recording();
        const auto file = now.file.empty() ? juce::String() : textOf(now.file.filename());
        record.setToggleState(now.isRunning, juce::dontSendNotification);
        record.describe(now.isRunning ? "Stop recording" : "Record",
                        now.isRunning ? "Stop, and keep the recording in the music folder"
                                      : "Record the sound to a WAV file in the music folder");
        const auto seconds = static_cast<int>(now.seconds);
        const auto time =
            juce::String(seconds / 60) + ":" + juce::String(seconds % 60).paddedLeft('0', 2);
        if (time != take.getButtonText())
            take.setButtonText(time);
        const auto text = now.isRunning ? juce::String("Recording")
                                        : file + ". Drag it into the host, or click to show it in "
                                                 "its folder.";
        if (text != take.getTooltip()) {
            take.setTooltip(text);
            showColour();
        }
        if (const bool isShown = now.isRunning || file.isNotEmpty(); isShown != take.isVisible()) {
            take.setVisible(isShown);
            juce::NullCheckedInvocation::invoke(onWidth);
        }
    }

    void resized() override {
        auto area = getLocalBounds().withTrimmedRight(gap);
        const auto place = [&](juce::Component& part, int width) {
            part.setBounds(
                area.removeFromRight(width).withSizeKeepingCentre(width - 2, button - 2));
        };
        place(record, button); // stays under the mouse when the time appears
        place(last, button);
        place(samples, button);
        if (take.isVisible())
            place(take, takeWidth);
    }
    void lookAndFeelChanged() override { showColour(); }

private:
    static constexpr int button = 28, takeWidth = 62, gap = 8;

    void refreshExport() {
        const auto now = exporting.sampleStatus();
        samples.setToggleState(now.isExporting(), juce::dontSendNotification);
        samples.describe("Export samples",
                         now.isExporting()
                             ? "Samples are being exported: " +
                                   juce::String(juce::roundToInt(100 * now.progress)) + " %"
                             : juce::String("Export samples: every key as files for a sampler, or "
                                            "places of an object for a game"));
    }

    /// Red while it records.
    void showColour() {
        take.setColour(
            juce::TextButton::textColourOffId,
            colourOf(*this, view.recording().isRunning ? LookColour::error : LookColour::text));
    }
    juce::File complete() const {
        const auto now = view.recording();
        return now.isRunning || now.file.empty() ? juce::File() : fileOf(now.file);
    }

    RecorderView& view;
    SampleView& exporting;
    IconButton samples{"Export samples", icons::samples()};
    CaptureButton<IconButton> last;
    IconButton record{"Record", icons::record()};
    DragOutButton<juce::TextButton> take; ///< the recording that runs or was made last
};

} // namespace idiophone
