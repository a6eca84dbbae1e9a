// The picture of the instrument, under a strip of switches for what it shows.
#pragma once

#include "Editor/CaptureButton.h"
#include "Editor/ObjectView.h"

#include <vector>

namespace idiophone {

class ObjectPane final : public juce::Component {
public:
    explicit ObjectPane(ProcessorView& processor);

    ObjectView& picture() { return object; }

    void refresh();

    void resized() override;

private:
    void add(juce::TextButton& button, const juce::String& tooltip, bool isSwitch);
    void setLayers();
    void showStageButtons();

    ProcessorView& view;
    ObjectView object;
    juce::TextButton vibration{"Vibration"}, nodes{"Nodal lines"}, path{"Strike path"},
        draw{"Draw path"};
    // These are visible on a stage only.
    juce::TextButton play{"Play"}, pause{"Pause"}, reset{"Reset"};
    CaptureButton midi, impulses;
    const std::vector<juce::TextButton*> strip{&vibration, &nodes, &path, &draw,    &play,
                                               &pause,     &reset, &midi, &impulses};
};

} // namespace idiophone
