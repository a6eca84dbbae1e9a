// The page with the modes of an object: marks the sounding ones, and mutes or solos them.
#pragma once

#include "Editor/DeckPage.h"
#include "Editor/ModeSpectrum.h"
#include "Editor/ProcessorView.h"

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <optional>

namespace idiophone {

class ModesPage final : public DeckPage {
public:
    explicit ModesPage(ProcessorView& view);

    void refresh() override;
    void showSound(const SoundFrame& frame) override;

    /// Called when the shown mode (hovered or chosen, of the last frame's object) changes or
    /// disappears.
    std::function<void(std::optional<std::size_t> mode)> onModeShown;

    void paint(juce::Graphics& g) override;
    void resized() override;
    void visibilityChanged() override { modeShown(); }

private:
    void listObjects();
    void modeShown();
    void describe();

    ProcessorView& view;
    int listedInstrument = -1;
    juce::ComboBox objects;
    juce::TextButton mute, alone, all;
    ModeSpectrum spectrum;
    juce::StringArray lines; ///< text about the shown mode
    juce::Rectangle<int> lineArea;
    std::optional<std::size_t> told; ///< last value passed to `onModeShown`
};

} // namespace idiophone
