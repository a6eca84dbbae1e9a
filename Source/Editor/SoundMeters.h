// Meters of the output level in dB of full scale, and of the load of one processor core.
#pragma once

#include "Editor/DescribedComponent.h"
#include "Editor/Look.h"
#include "Editor/SoundView.h"

#include <algorithm>
#include <array>
#include <juce_audio_basics/juce_audio_basics.h>

namespace idiophone {

/// Three rows; needs at least 240 x 48 px.
class SoundMeters final : public DescribedComponent {
public:
    SoundMeters() : DescribedComponent(juce::AccessibilityRole::progressBar), rows(rowsNow()) {
        setTitle("Level and load");
        setTooltip("Peaks in dB of full scale; load in per cent of one processor core");
    }

    /// Call for every frame: peaks fall by a fixed amount per call. Repaints only if the picture
    /// changes.
    void show(const SoundFrame& frame) {
        const std::array peaks{frame.peakLeft, frame.peakRight};
        for (std::size_t channel = 0; channel < 2; ++channel)
            decibels[channel] = std::max({juce::Decibels::gainToDecibels(
                                              static_cast<double>(peaks[channel]), silentDecibels),
                                          decibels[channel] - fallPerFrame, silentDecibels});
        load += loadShare * (static_cast<double>(frame.load) - load);
        auto next = rowsNow();
        if (next == rows)
            return;
        rows = std::move(next);
        repaint();
    }

    juce::String description() const override {
        juce::StringArray parts;
        for (const Row& row : rows)
            parts.add(juce::String(row.name) + " " + row.text);
        return parts.joinIntoString(", ");
    }

    void paint(juce::Graphics& g) override {
        auto area = getLocalBounds();
        const int height = area.getHeight() / static_cast<int>(rows.size());
        g.setFont(Look::textFont(12.5f));
        for (const Row& row : rows) {
            auto line = area.removeFromTop(height);
            g.setColour(colourOf(*this, LookColour::dimText));
            g.drawText(row.name, line.removeFromLeft(nameWidth), juce::Justification::centredLeft,
                       false);
            g.setColour(colourOf(*this, row.isOver ? LookColour::error : LookColour::text));
            g.drawText(row.text, line.removeFromRight(textWidth), juce::Justification::centredRight,
                       false);
            const auto track = line.toFloat().withSizeKeepingCentre(
                static_cast<float>(std::max(line.getWidth() - 4, 1)), 6);
            g.setColour(colourOf(*this, LookColour::outline));
            g.fillRoundedRectangle(track, 3);
            g.setColour(colourOf(*this, row.isOver ? LookColour::error : LookColour::accent));
            if (row.filled > 0)
                g.fillRoundedRectangle(
                    track.withWidth(track.getWidth() * static_cast<float>(row.filled) / 1000), 3);
        }
    }

private:
    static constexpr double fallPerFrame = 0.8; // dB; slow enough to see a peak
    static constexpr double loadShare = 0.15; // step towards the newest value; slow enough to read
    static constexpr int nameWidth = 38, textWidth = 68;

    static constexpr double silentDecibels = -60;

    struct Row {
        const char* name;
        juce::String text;
        int filled = 0; ///< thousandths
        bool isOver = false;

        bool operator==(const Row&) const = default;
    };

    std::array<Row, 3> rowsNow() const {
        std::array<Row, 3> result{{{.name = "Left", .text = {}},
                                   {.name = "Right", .text = {}},
                                   {.name = "CPU", .text = {}}}};
        for (std::size_t channel = 0; channel < 2; ++channel) {
            const double now = decibels[channel];
            result[channel].text = now > silentDecibels
                                       ? juce::String(juce::roundToInt(now)) + " dB"
                                       : juce::String("silent");
            result[channel].filled =
                juce::roundToInt(1000 * std::clamp(1 - now / silentDecibels, 0.0, 1.0));
            result[channel].isOver = now > 0;
        }
        result[2].text = (load < 0.0995 ? juce::String(100 * load, 1)
                                        : juce::String(juce::roundToInt(100 * load))) +
                         " %";
        result[2].filled = juce::roundToInt(200 * std::clamp(load, 0.0, 1.0)) * 5;
        result[2].isOver = load > 0.9;
        return result;
    }

    std::array<double, 2> decibels{silentDecibels, silentDecibels}; ///< as displayed
    double load = 0;                                                ///< as displayed, smoothed
    std::array<Row, 3> rows;
};

} // namespace idiophone
