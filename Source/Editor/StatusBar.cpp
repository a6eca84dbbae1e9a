#include "Editor/StatusBar.h"

#include "Editor/Look.h"

#include <cmath>
#include <juce_audio_basics/juce_audio_basics.h>

namespace idiophone {

namespace {

int widthOf(const juce::String& text) {
    return juce::roundToInt(
        std::ceil(juce::GlyphArrangement::getStringWidth(juce::Font(Look::textFont()), text)));
}

} // namespace

void StatusBar::show(ProcessorView::Status status) {
    constexpr int fallPerUpdate = 2; // dB: a peak can be seen
    const auto now = static_cast<int>(std::lround(
        juce::Decibels::gainToDecibels(status.peak, static_cast<float>(silentDecibels))));
    const int decibels = juce::jmax(now, shownDecibels - fallPerUpdate, silentDecibels);
    const bool same = decibels == shownDecibels && status.modesMixed == shown.modesMixed &&
                      status.isError == shown.isError && status.sentence == shown.sentence &&
                      status.delaySeconds == shown.delaySeconds &&
                      status.lateBlows == shown.lateBlows;
    shown = std::move(status);
    shownDecibels = decibels;
    if (!same)
        repaint();
}

juce::String StatusBar::delayText() const {
    if (!(shown.delaySeconds > 0))
        return {};
    const auto delay =
        "heard " + juce::String(juce::roundToInt(1000 * shown.delaySeconds)) + " ms after the key";
    return shown.lateBlows == 0 ? delay
                                : delay + ", " + juce::String(shown.lateBlows) +
                                      (shown.lateBlows == 1 ? " blow late" : " blows late");
}

void StatusBar::paint(juce::Graphics& g) {
    auto area = getLocalBounds();
    const auto meter = area.removeFromRight(120).toFloat().withSizeKeepingCentre(120, 6);
    const auto modes = area.removeFromRight(110).withTrimmedRight(12);
    const float filled = static_cast<float>(shownDecibels - silentDecibels) / -silentDecibels;
    g.setColour(colourOf(*this, LookColour::outline));
    g.fillRoundedRectangle(meter, 3);
    g.setColour(shownDecibels >= 0 ? colourOf(*this, LookColour::error)
                                   : colourOf(*this, LookColour::accent));
    g.fillRoundedRectangle(meter.withWidth(meter.getWidth() * juce::jlimit(0.0f, 1.0f, filled)), 3);

    g.setFont(Look::textFont());
    g.setColour(colourOf(*this, LookColour::dimText));
    g.drawText(juce::String(shown.modesMixed) + (shown.modesMixed == 1 ? " mode" : " modes"), modes,
               juce::Justification::centredRight);
    if (const auto delay = delayText(); delay.isNotEmpty())
        g.drawText(delay, area.removeFromRight(widthOf(delay) + 24).withTrimmedRight(12),
                   juce::Justification::centredRight);
    g.setColour(shown.isError ? colourOf(*this, LookColour::error)
                              : colourOf(*this, LookColour::text));
    g.drawFittedText(juce::String::fromUTF8(shown.sentence.c_str()), area,
                     juce::Justification::centredLeft, 2, 0.85f);
}

} // namespace idiophone
