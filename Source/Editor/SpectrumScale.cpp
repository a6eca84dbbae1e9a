#include "Editor/SpectrumScale.h"

#include "Editor/ModeText.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace idiophone {
namespace {

constexpr std::array roundHz{10.0,   20.0,   50.0, 100.0, 200.0, 500.0, 1000.0,
                             2000.0, 5000.0, 1e4,  2e4,   5e4,   1e5};
constexpr double margin = 1.04; // keeps modes off the edge
constexpr double decibelsPerTick = 30;

juce::String tickText(double hz) {
    return hz < 1000 ? juce::String(juce::roundToInt(hz))
                     : juce::String(juce::roundToInt(hz / 1000)) + "k";
}

/// Position between the bounds, 0 to 1.
double share(double value, double lower, double upper) {
    return std::clamp((value - lower) / (upper - lower), 0.0, 1.0);
}

} // namespace

SpectrumScale::SpectrumScale(std::span<const double> frequenciesHz,
                             juce::Rectangle<float> levels,
                             juce::Rectangle<float> decays)
    : levelArea(levels), decayArea(decays) {
    if (frequenciesHz.empty())
        return;
    const auto [least, most] = std::ranges::minmax(frequenciesHz);
    const auto above = std::ranges::upper_bound(roundHz, least / margin);
    const auto from = std::min(above == roundHz.begin() ? above : above - 1, roundHz.end() - 3);
    lowest = *from;
    auto to = std::ranges::lower_bound(roundHz, std::max(most * margin, 4 * lowest));
    highest = to == roundHz.end() ? roundHz.back() : *to;
}

float SpectrumScale::x(double frequencyHz) const {
    const double place =
        share(std::log(std::max(frequencyHz, 1.0)), std::log(lowest), std::log(highest));
    return levelArea.getX() + static_cast<float>(place) * levelArea.getWidth();
}

float SpectrumScale::levelY(double decibels) const {
    const double place = share(decibels, faintestDecibels, highestDecibels);
    return levelArea.getBottom() - static_cast<float>(place) * levelArea.getHeight();
}

float SpectrumScale::decayY(double t60Seconds) const {
    const double place = share(std::log(std::max(t60Seconds, 1e-9)), std::log(shortestSeconds),
                               std::log(longestSeconds));
    return decayArea.getBottom() - static_cast<float>(place) * decayArea.getHeight();
}

std::vector<SpectrumScale::Tick> SpectrumScale::frequencyTicks(float minimumGap) const {
    std::vector<Tick> ticks;
    for (const double hz : roundHz) {
        if (hz < lowest || hz > highest)
            continue;
        const Tick tick{.at = x(hz), .text = tickText(hz)};
        if (ticks.empty() || tick.at - ticks.back().at >= minimumGap)
            ticks.push_back(tick);
    }
    return ticks;
}

std::vector<SpectrumScale::Tick> SpectrumScale::levelTicks() const {
    std::vector<Tick> ticks;
    for (double decibels = highestDecibels; decibels >= faintestDecibels;
         decibels -= decibelsPerTick)
        ticks.push_back({.at = levelY(decibels), .text = juce::String(juce::roundToInt(decibels))});
    return ticks;
}

std::vector<SpectrumScale::Tick> SpectrumScale::decayTicks() const {
    std::vector<Tick> ticks;
    for (const double seconds : {0.1, 1.0, 10.0})
        ticks.push_back(
            {.at = decayY(seconds),
             .text = seconds < 1 ? "0.1 s" : juce::String(juce::roundToInt(seconds)) + " s"});
    return ticks;
}

} // namespace idiophone
