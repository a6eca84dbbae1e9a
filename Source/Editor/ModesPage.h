// The page of the deck that shows the modes of an object, which of them sound, and mutes them.
#pragma once

#include "Editor/DeckPage.h"
#include "Editor/ModeSpectrum.h"
#include "Editor/ProcessorView.h"

#include <cstdint>
#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <optional>

namespace idiophone {

class ModesPage final : public DeckPage {
public:
    explicit ModesPage(ProcessorView& view);

    void refresh() override;
    void showSound(const SoundFrame& frame) override;

    /// The mode under the mouse or chosen by hand has changed: its number, and the index of its
    /// object among ProcessorView::playedObjects; or there is none.
    std::function<void(std::size_t object, std::optional<std::int32_t> mode)> onModeShown;

    void paint(juce::Graphics& g) override;
    void resized() override;

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
    std::optional<std::pair<std::size_t, std::int32_t>> told; ///< object and mode, to `onModeShown`
};

} // namespace idiophone
