// The axes of the mode spectrum: logarithmic frequency, level in dB, logarithmic decay time.
#pragma once

#include <juce_graphics/juce_graphics.h>
#include <span>
#include <vector>

namespace idiophone {

class SpectrumScale {
public:
    static constexpr double highestDecibels = 0;
    static constexpr double shortestSeconds = 0.01, longestSeconds = 30;

    struct Tick {
        float at = 0; ///< px
        juce::String text;
    };

    /// The frequency axis runs between round values, contains all `frequenciesHz` and spans at
    /// least two octaves; without frequencies it is 20 Hz to 20 kHz. `levels` and `decays` have the
    /// same width.
    SpectrumScale(std::span<const double> frequenciesHz,
                  juce::Rectangle<float> levels,
                  juce::Rectangle<float> decays);

    juce::Rectangle<float> levels() const { return levelArea; }
    juce::Rectangle<float> decays() const { return decayArea; }
    double lowestHz() const { return lowest; }
    double highestHz() const { return highest; }

    float x(double frequencyHz) const;
    float levelY(double decibels) const;   ///< clamped to the axis
    float decayY(double t60Seconds) const; ///< longer is higher; clamped to the axis

    /// Ticks at 20, 50, 100 ... that are at least `minimumGap` apart.
    std::vector<Tick> frequencyTicks(float minimumGap) const;
    std::vector<Tick> levelTicks() const;
    std::vector<Tick> decayTicks() const;

private:
    double lowest = 20, highest = 20000;
    juce::Rectangle<float> levelArea, decayArea;
};

} // namespace idiophone
