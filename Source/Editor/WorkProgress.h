// Shows how far background work is: a bar, and the time that is left.
#pragma once

#include "Editor/Look.h"

#include <algorithm>

namespace idiophone {

inline juce::String timeLeftText(int seconds) {
    return "about " +
           (seconds < 90 ? juce::String(seconds) + " s"
                         : juce::String((seconds + 30) / 60) + " min") +
           " left";
}

/// `progress` is 0 to 1.
inline void paintProgress(juce::Graphics& g,
                          const juce::Component& of,
                          juce::Rectangle<int> bar,
                          double progress) {
    const auto track = bar.toFloat();
    g.setColour(colourOf(of, LookColour::outline));
    g.fillRoundedRectangle(track, track.getHeight() / 2);
    g.setColour(colourOf(of, LookColour::accent));
    g.fillRoundedRectangle(track.withWidth(std::max(
                               track.getHeight(), track.getWidth() * static_cast<float>(progress))),
                           track.getHeight() / 2);
}

} // namespace idiophone
