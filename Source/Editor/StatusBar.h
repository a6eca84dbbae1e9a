// One line: what is loaded or what went wrong, how late a stage is heard, how many modes sound, how
// loud it is.
#pragma once

#include "Editor/ProcessorView.h"

#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

class StatusBar final : public juce::Component {
public:
    void show(ProcessorView::Status status);

    void paint(juce::Graphics& g) override;

private:
    juce::String delayText() const;

    ProcessorView::Status shown;
    int shownDecibels = silentDecibels;
    static constexpr int silentDecibels = -60;
};

} // namespace idiophone
