// The picture of an object's modes: a line for the level and a dot for the decay time of each.
#pragma once

#include "Editor/SoundView.h"
#include "Editor/SpectrumScale.h"

#include <juce_gui_basics/juce_gui_basics.h>
#include <optional>
#include <vector>

namespace idiophone {

class SpectrumPicture {
public:
    /// Takes a frame and the size of the picture. Returns whether the picture has changed.
    bool update(const SoundFrame& frame, juce::Rectangle<int> bounds);

    /// Returns the mode nearest in frequency. Of several equally near modes, returns the one whose
    /// line ends nearest.
    std::optional<std::size_t> modeAt(juce::Point<float> position) const;

    /// Paints with the component's colours, and emphasises one mode.
    void paint(juce::Graphics& g,
               const juce::Component& component,
               std::optional<std::size_t> emphasised) const;

private:
    /// One mode as drawn, in whole pixels, so that equal pictures compare equal.
    struct Line {
        int x = 0;
        int top = 0;
        int decayY = 0;
        std::int32_t group = 0;
        ModeStanding standing = ModeStanding::belowTau;
        bool isMuted = false;
        bool isHeardAlone = false;

        bool operator==(const Line&) const = default;
    };

    SpectrumScale scale{{}, {}, {}};
    std::vector<Line> lines;
    int tauY = 0;
};

} // namespace idiophone
