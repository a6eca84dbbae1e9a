// One line: what is loaded or what went wrong, how late a stage is heard, how many modes sound, how
// loud it is.
#pragma once

#include "Editor/ProcessorView.h"

#include <juce_gui_basics/juce_gui_basics.h>
#include <memory>

namespace idiophone {

class StatusBar final : public juce::Component {
public:
    StatusBar();

    /// A new error is read out, too.
    void show(ProcessorView::Status status);

    void paint(juce::Graphics& g) override;
    std::unique_ptr<juce::AccessibilityHandler> createAccessibilityHandler() override;

private:
    juce::String modesText() const;
    juce::String delayText() const;
    juce::String description() const;

    ProcessorView::Status shown;
    int shownDecibels = silentDecibels;
    static constexpr int silentDecibels = -60;
};

} // namespace idiophone
