// The picture of the instrument, under a strip of switches for what it shows.
#pragma once

#include "Editor/CaptureButton.h"
#include "Editor/ObjectView.h"

namespace idiophone {

class ObjectPane final : public juce::Component {
public:
    static constexpr int stripHeight = 28;

    explicit ObjectPane(ProcessorView& processor);

    ObjectView& picture() { return object; }

    void refresh();

    void resized() override;

private:
    void addSwitch(juce::TextButton& button,
                   const juce::String& tooltip,
                   void (ObjectView::*change)(bool),
                   bool on);

    void addStageButton(juce::TextButton& button, const juce::String& tooltip);
    void showStageButtons();

    ProcessorView& view;
    ObjectView object;
    juce::TextButton vibration{"Vibration"}, nodes{"Nodal lines"}, path{"Strike path"},
        draw{"Draw path"};
    // Only on a stage.
    juce::TextButton play{"Play"}, pause{"Pause"}, reset{"Reset"};
    CaptureButton midi, impulses;
};

} // namespace idiophone
