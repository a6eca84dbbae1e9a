// Where modes stand in the picture of their spectrum: logarithmic frequency, level in dB, and
// logarithmic decay time.
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

    /// A scale from one round frequency to another, which holds all of these and at least two
    /// octaves; the whole of hearing where there are none. Levels stand in `levels`, decay times in
    /// `decays`, both as wide.
    SpectrumScale(std::span<const double> frequenciesHz,
                  juce::Rectangle<float> levels,
                  juce::Rectangle<float> decays);

    double lowestHz() const { return lowest; }
    double highestHz() const { return highest; }

    float x(double frequencyHz) const;
    float levelY(double decibels) const;   ///< out of range: at its end
    float decayY(double t60Seconds) const; ///< the longer the higher

    /// 20, 50, 100 ...: as many as stand apart by `leastGap`.
    std::vector<Tick> frequencyTicks(float leastGap) const;
    std::vector<Tick> levelTicks() const;
    std::vector<Tick> decayTicks() const;

private:
    double lowest = 20, highest = 20000;
    juce::Rectangle<float> levelArea, decayArea;
};

} // namespace idiophone
