// The output as sound files: a button for the last seconds.
#pragma once

#include "Editor/CaptureButton.h"
#include "Editor/IconButton.h"
#include "Editor/Icons.h"
#include "Editor/Look.h"
#include "Editor/ProcessorView.h"

#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

class RecorderStrip final : public juce::Component {
public:
    explicit RecorderStrip(ProcessorView& view)
        : last(view.status, soundCapture(view.recorder), "Last 30 seconds", icons::soundFile()) {
        view.recorder.keepLastSound();
        last.describe(
            "Last 30 seconds",
            "The last 30 seconds as a WAV file. Drag it into the host, or click to save.");
        addAndMakeVisible(last);
    }

    /// The width that it needs, in pixels.
    int width() const { return button + gap; }

    void resized() override {
        last.setBounds(
            getLocalBounds().removeFromLeft(button).withSizeKeepingCentre(button, button));
    }

private:
    static constexpr int button = 28, gap = 8;

    CaptureButton<IconButton> last;
};

} // namespace idiophone
