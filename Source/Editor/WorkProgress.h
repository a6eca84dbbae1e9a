// How far long work has come: a bar, and the words beside it.
#pragma once

#include "Editor/Look.h"
#include "Editor/Utf8.h"

#include <algorithm>
#include <optional>
#include <string>

namespace idiophone {

/// "Solving for modes...", or with an estimate "Solving for modes, about 12 s left".
inline juce::String workText(const std::string& step, std::optional<int> secondsLeft) {
    if (!secondsLeft)
        return fromUtf8(step) + "...";
    return fromUtf8(step) + ", about " +
           (*secondsLeft < 90 ? juce::String(*secondsLeft) + " s"
                              : juce::String((*secondsLeft + 30) / 60) + " min") +
           " left";
}

/// For the eye; the words say it to a screen reader.
class WorkBar final : public juce::Component {
public:
    static constexpr int height = 4;

    WorkBar() {
        setAccessible(false);
        setInterceptsMouseClicks(false, false);
    }

    /// Shows the fraction that is done, 0 to 1.
    void show(double fraction) {
        if (fraction == shown)
            return;
        shown = fraction;
        repaint();
    }

    void paint(juce::Graphics& g) override {
        const auto track = getLocalBounds().toFloat();
        const float round = track.getHeight() / 2;
        g.setColour(colourOf(*this, LookColour::outline));
        g.fillRoundedRectangle(track, round);
        g.setColour(colourOf(*this, LookColour::accent));
        g.fillRoundedRectangle(
            track.withWidth(std::max(2 * round, track.getWidth() * static_cast<float>(shown))),
            round);
    }

private:
    double shown = 0;
};

} // namespace idiophone
