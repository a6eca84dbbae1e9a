// The page of the tuning: a scale from a file or the session, concert pitch, and bend ranges.
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
