#include "Editor/StatusBar.h"

#include "Editor/DescribedValue.h"
#include "Editor/Look.h"
#include "Editor/Utf8.h"

#include <cmath>
#include <juce_audio_basics/juce_audio_basics.h>

namespace idiophone {

namespace {

/// The part of a text that fits on the line. It may come from a file or host, and long texts are
/// slow to lay out.
juce::String seenOf(const std::string& sentence) {
    constexpr std::size_t mostBytes = 2000;
    constexpr int mostLetters = 400;
    return fromUtf8(std::string_view(sentence).substr(0, mostBytes)).substring(0, mostLetters);
}

int widthOf(const juce::String& text) {
    return juce::roundToInt(
        std::ceil(juce::GlyphArrangement::getStringWidth(juce::Font(Look::textFont()), text)));
}

} // namespace

StatusBar::StatusBar() {
    setTitle("Status");
}

void StatusBar::show(StatusView::Status status) {
    constexpr int fallPerUpdate = 2; // dB; slow enough to see a peak
    const auto now = static_cast<int>(std::lround(
        juce::Decibels::gainToDecibels(status.peak, static_cast<float>(silentDecibels))));
    const int decibels = juce::jmax(now, shownDecibels - fallPerUpdate, silentDecibels);
    const bool sameSentence = status.isError == shown.isError && status.sentence == shown.sentence;
    const bool same = decibels == shownDecibels && status.modesMixed == shown.modesMixed &&
                      sameSentence && status.delaySeconds == shown.delaySeconds &&
                      status.lateImpacts == shown.lateImpacts;
    shown = std::move(status);
    shownDecibels = decibels;
    if (!same)
        repaint();
    if (sameSentence)
        return;
    if (auto* handler = getAccessibilityHandler())
        handler->notifyAccessibilityEvent(juce::AccessibilityEvent::valueChanged);
    if (shown.isError)
        juce::AccessibilityHandler::postAnnouncement(
            fromUtf8(shown.sentence), juce::AccessibilityHandler::AnnouncementPriority::high);
}

juce::String StatusBar::modesText() const {
    return juce::String(shown.modesMixed) + (shown.modesMixed == 1 ? " mode" : " modes");
}

juce::String StatusBar::delayText() const {
    if (!(shown.delaySeconds > 0))
        return {};
    const auto delay =
        "heard " + juce::String(juce::roundToInt(1000 * shown.delaySeconds)) + " ms after the key";
    return shown.lateImpacts == 0 ? delay
                                  : delay + ", " + juce::String(shown.lateImpacts) +
                                        (shown.lateImpacts == 1 ? " impact late" : " impacts late");
}

juce::String StatusBar::description() const {
    juce::StringArray parts{fromUtf8(shown.sentence), delayText(), modesText()};
    parts.removeEmptyStrings();
    return parts.joinIntoString("; ");
}

std::unique_ptr<juce::AccessibilityHandler> StatusBar::createAccessibilityHandler() {
    return describedValue(*this, juce::AccessibilityRole::staticText,
                          [this] { return description(); });
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
    g.drawText(modesText(), modes, juce::Justification::centredRight);
    if (const auto delay = delayText(); delay.isNotEmpty())
        g.drawText(delay, area.removeFromRight(widthOf(delay) + 24).withTrimmedRight(12),
                   juce::Justification::centredRight);
    g.setColour(shown.isError ? colourOf(*this, LookColour::error)
                              : colourOf(*this, LookColour::text));
    g.drawFittedText(seenOf(shown.sentence), area, juce::Justification::centredLeft, 2, 0.85f);
}

} // namespace idiophone
