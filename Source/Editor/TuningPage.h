// What the keys are tuned to: a scale's file or the session's, concert pitch, and how far wheels
// bend.
#pragma once

#include "Editor/DeckPage.h"
#include "Editor/FileButton.h"
#include "Editor/ParameterColumns.h"

namespace idiophone {

class TuningPage final : public DeckPage {
public:
    explicit TuningPage(ProcessorView& view);

    void refresh() override;
    void resized() override;
    void lookAndFeelChanged() override;

private:
    void showTuning();

    ProcessorView& view;
    TuningStatus shown;
    juce::Label scale, origin;
    FileButton open;
    juce::TextButton forget{"Forget"};
    ParameterColumns columns;
};

} // namespace idiophone
