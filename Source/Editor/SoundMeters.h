// How loud the output is, in dB of full scale, and what share of one processor the sound takes.
#pragma once

#include "Editor/SoundView.h"

#include <array>
#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

/// Three rows; readable from 240 x 48 px on.
class SoundMeters final : public juce::Component, public juce::SettableTooltipClient {
public:
    SoundMeters();

    /// For every frame: peaks fall in time with them. Repaints where that looks different.
    void show(const SoundFrame& frame);

    juce::String description() const;

    void paint(juce::Graphics& g) override;
    std::unique_ptr<juce::AccessibilityHandler> createAccessibilityHandler() override;

private:
    static constexpr double silentDecibels = -60;

    struct Row {
        const char* name;
        juce::String text;
        int filled = 0; ///< thousandths
        bool isOver = false;

        bool operator==(const Row&) const = default;
    };

    std::array<Row, 3> rowsNow() const;

    std::array<double, 2> decibels{silentDecibels, silentDecibels}; ///< as seen: falling
    double load = 0;                                                ///< as seen: smooth
    std::array<Row, 3> rows;
};

} // namespace idiophone
