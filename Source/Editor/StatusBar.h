// The status line: the loaded sound or an error, the delay of a stage, sounding modes and output
// level.
#pragma once

#include "Editor/ProcessorView.h"

#include <juce_gui_basics/juce_gui_basics.h>
#include <memory>

namespace idiophone {

class StatusBar final : public juce::Component {
public:
    StatusBar();

    /// The screen reader announces a new error.
    void show(StatusView::Status status);

    void paint(juce::Graphics& g) override;
    std::unique_ptr<juce::AccessibilityHandler> createAccessibilityHandler() override;

private:
    juce::String modesText() const;
    juce::String delayText() const;
    juce::String description() const;

    StatusView::Status shown;
    int shownDecibels = silentDecibels;
    static constexpr int silentDecibels = -60;
};

} // namespace idiophone
