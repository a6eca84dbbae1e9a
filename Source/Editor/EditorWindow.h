// The plugin's window: presets, the instrument itself, parameters, status and keyboard, one above
// the other.
#pragma once

#include "Editor/DarkLook.h"
#include "Editor/KeyboardPanel.h"
#include "Editor/ObjectView.h"
#include "Editor/ParameterPanel.h"
#include "Editor/PresetBar.h"
#include "Editor/ProcessorView.h"
#include "Editor/StatusBar.h"

#include <juce_audio_processors/juce_audio_processors.h>

namespace idiophone {

class EditorWindow final : public juce::AudioProcessorEditor, private juce::Timer {
public:
    EditorWindow(juce::AudioProcessor& processor, ProcessorView& view);
    ~EditorWindow() override;

    void paint(juce::Graphics& g) override;
    void resized() override;

private:
    void timerCallback() override;

    ProcessorView& view;
    DarkLook look;
    PresetBar presets;
    ObjectView object;
    ParameterPanel parameters;
    StatusBar status;
    KeyboardPanel keyboard;
    juce::TooltipWindow tooltips{this, 600};
    bool focusTaken = false;
};

} // namespace idiophone
