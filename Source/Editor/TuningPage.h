// What the keys are tuned to: a scale's file or the session's, concert pitch, and how far wheels
// bend.
#pragma once

#include "Editor/DeckPage.h"
#include "Editor/ParameterColumns.h"

#include <memory>

namespace idiophone {

class TuningPage final : public DeckPage {
public:
    explicit TuningPage(ProcessorView& view);

    void refresh() override;
    void resized() override;
    void lookAndFeelChanged() override;

private:
    void addButton(juce::TextButton& button,
                   const juce::String& title,
                   const juce::String& tooltip,
                   std::function<void()> action);
    void chooseFile();
    void showTuning();

    ProcessorView& view;
    TuningStatus shown;
    juce::Label scale, origin;
    juce::TextButton open{"Open..."}, forget{"Forget"};
    ParameterColumns columns;
    std::unique_ptr<juce::FileChooser> chooser;
};

} // namespace idiophone
