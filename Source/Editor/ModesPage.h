// The page of the deck that shows the modes of an object, which of them sound, and mutes them.
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

    /// The mode under the mouse or chosen by hand, of the object of the frame shown last, is
    /// another one, or there is none any more.
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
    juce::StringArray lines; ///< on the mode shown
    juce::Rectangle<int> lineArea;
    std::optional<std::size_t> told; ///< to `onModeShown`
};

} // namespace idiophone
