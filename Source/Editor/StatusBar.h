// The status line: the loaded sound or an error, or a hint; the delay of a stage, sounding modes
// and output level, with a mark for peaks that reach the limiter.
#pragma once

#include "Editor/DescribedComponent.h"
#include "Editor/Look.h"
#include "Editor/ProcessorView.h"
#include "Editor/Utf8.h"

#include <algorithm>
#include <cmath>
#include <juce_audio_basics/juce_audio_basics.h>

namespace idiophone {

class StatusBar final : public DescribedComponent {
public:
    StatusBar() : DescribedComponent(juce::AccessibilityRole::staticText) {
        setTitle("Status");
        setTooltip("Level; a red mark says that a peak reached the limiter. Click to clear it.");
    }

    /// The screen reader announces a new error.
    void show(StatusView::Status status) {
        constexpr int fallPerUpdate = 2; // dB; slow enough to see a peak
        const auto now = static_cast<int>(std::lround(
            juce::Decibels::gainToDecibels(status.peak, static_cast<float>(silentDecibels))));
        const int decibels = juce::jmax(now, shownDecibels - fallPerUpdate, silentDecibels);
        const bool sameSentence =
            status.isError == shown.isError && status.sentence == shown.sentence;
        const bool marks = hasPeaked || now > peakDecibels;
        const bool hadHint = showsHint();
        if (sameSentence)
            updatesToKeep = std::max(updatesToKeep - 1, 0);
        else
            updatesToKeep = status.isError ? errorUpdates : sentenceUpdates;
        const bool same = marks == hasPeaked && decibels == shownDecibels &&
                          status.modesMixed == shown.modesMixed && sameSentence &&
                          status.delaySeconds == shown.delaySeconds &&
                          status.lateEvents == shown.lateEvents;
        shown = std::move(status);
        shownDecibels = decibels;
        hasPeaked = marks;
        if (!same || showsHint() != hadHint)
            repaint();
        if (sameSentence)
            return;
        notifyDescriptionChanged();
        if (shown.isError)
            juce::AccessibilityHandler::postAnnouncement(
                fromUtf8(shown.sentence), juce::AccessibilityHandler::AnnouncementPriority::high);
    }

    /// Shows the hint instead of the sentence; an empty one ends it. A new sentence or error stays
    /// for some updates first, and returns after the hint.
    void showHint(const juce::String& text) {
        if (text == hint)
            return;
        const auto before = line();
        hint = text;
        if (line() != before)
            repaint();
    }
    /// The text of the line: the sentence or the hint.
    juce::String line() const { return showsHint() ? hint : seenOf(shown.sentence); }

    /// Returns a text as the line shows it where no delay is shown: on up to three lines, and cut
    /// if it is longer.
    juce::GlyphArrangement fitted(const juce::String& text) const {
        return fittedIn(text,
                        getLocalBounds().withTrimmedRight(modesWidth + meterWidth + markWidth));
    }

    void paint(juce::Graphics& g) override {
        auto area = getLocalBounds();
        const auto mark = area.removeFromRight(markWidth).toFloat().withSizeKeepingCentre(6, 6);
        const auto meter = area.removeFromRight(meterWidth).toFloat().withSizeKeepingCentre(84, 6);
        const auto modes = area.removeFromRight(modesWidth).withTrimmedRight(12);
        const float filled = static_cast<float>(shownDecibels - silentDecibels) / -silentDecibels;
        g.setColour(colourOf(*this, LookColour::outline));
        g.fillRoundedRectangle(meter, 3);
        g.setColour(colourOf(*this, hasPeaked ? LookColour::error : LookColour::outline));
        g.fillEllipse(mark);
        g.setColour(
            colourOf(*this, shownDecibels > peakDecibels ? LookColour::error : LookColour::accent));
        g.fillRoundedRectangle(meter.withWidth(meter.getWidth() * juce::jlimit(0.0f, 1.0f, filled)),
                               3);

        g.setFont(Look::textFont());
        g.setColour(colourOf(*this, LookColour::dimText));
        g.drawText(modesText(), modes, juce::Justification::centredRight);
        if (const auto delay = delayText(); delay.isNotEmpty() && !showsHint()) {
            const int width = juce::GlyphArrangement::getStringWidthInt(Look::textFont(), delay);
            g.drawText(delay, area.removeFromRight(width + 24).withTrimmedRight(12),
                       juce::Justification::centredRight);
        }
        g.setColour(colourOf(*this, showsHint()     ? LookColour::dimText
                                    : shown.isError ? LookColour::error
                                                    : LookColour::text));
        fittedIn(line(), area).draw(g);
    }
    juce::String description() const override {
        juce::StringArray parts{fromUtf8(shown.sentence), delayText(), modesText(),
                                hasPeaked ? "peaked" : ""};
        parts.removeEmptyStrings();
        return parts.joinIntoString("; ");
    }

    void mouseDown(const juce::MouseEvent&) override {
        hasPeaked = false;
        repaint();
    }

private:
    /// Returns the part of a text that fits on the line. A text from a file or host may be long,
    /// and long texts are slow to lay out.
    static juce::String seenOf(const std::string& sentence) {
        return fromUtf8(std::string_view(sentence).substr(0, 2000)).substring(0, 400);
    }

    static juce::GlyphArrangement fittedIn(const juce::String& text, juce::Rectangle<int> area) {
        constexpr int maximumLines = 3;
        constexpr float minimumScale = 0.8f; // of the width
        juce::GlyphArrangement glyphs;
        glyphs.addFittedText(Look::textFont(), text, float(area.getX()), float(area.getY()),
                             float(area.getWidth()), float(area.getHeight()),
                             juce::Justification::centredLeft, maximumLines, minimumScale);
        return glyphs;
    }

    bool showsHint() const { return hint.isNotEmpty() && updatesToKeep == 0; }
    juce::String modesText() const {
        return juce::String(shown.modesMixed) + (shown.modesMixed == 1 ? " mode" : " modes");
    }
    juce::String delayText() const {
        if (!(shown.delaySeconds > 0))
            return {};
        const auto delay = "heard " + juce::String(juce::roundToInt(1000 * shown.delaySeconds)) +
                           " ms after the key";
        return shown.lateEvents == 0 ? delay
                                     : delay + ", " + juce::String(shown.lateEvents) + " late";
    }

    static constexpr int markWidth = 10, meterWidth = 88, modesWidth = 92;
    static constexpr int sentenceUpdates = 100, errorUpdates = 250; ///< 4 s and 10 s in use

    StatusView::Status shown;
    juce::String hint;
    int updatesToKeep = 0; ///< before a hint may replace the sentence
    int shownDecibels = silentDecibels;
    bool hasPeaked = false; ///< since the last click
    static constexpr int silentDecibels = -60;
    static constexpr int peakDecibels = -1; ///< the limiter's threshold
};

} // namespace idiophone
