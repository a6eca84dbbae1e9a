// Meters of the output level in dB of full scale, and of the load of one processor core.
#pragma once

#include "Editor/SoundView.h"

#include <array>
#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

/// Three rows; needs at least 240 x 48 px.
class SoundMeters final : public juce::Component, public juce::SettableTooltipClient {
public:
    SoundMeters();

    /// Call for every frame: peaks fall by a fixed amount per call. Repaints only if the picture
    /// changes.
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

    std::array<double, 2> decibels{silentDecibels, silentDecibels}; ///< as displayed
    double load = 0;                                                ///< as displayed, smoothed
    std::array<Row, 3> rows;
};

} // namespace idiophone
