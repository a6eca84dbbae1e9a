#include "Editor/QualityPage.h"

#include "Editor/DescribedValue.h"
#include "Editor/Look.h"

#include <utility>
#include <vector>

namespace idiophone {
namespace {

constexpr int columnsHeight = 74, tallColumnsHeight = 100, countHeight = 38, metersHeight = 51;
constexpr int gap = 6, heightForTall = 360;

std::vector<ParameterGroup> groups() {
    return {{"Modes that sound", 0}, {"Budget", 1}};
}

} // namespace

QualityPage::Counts::Counts() {
    setTitle("Modes");
}

void QualityPage::Counts::show(const SoundFrame& frame) {
    const std::array now{frame.modesMixed, frame.modesDropped, frame.modesMerged,
                         frame.modesBeyond};
    for (std::size_t k = 0; k < counts.size(); ++k)
        if (std::exchange(counts[k].modes, now[k]) != now[k])
            repaint();
}

std::unique_ptr<juce::AccessibilityHandler> QualityPage::Counts::createAccessibilityHandler() {
    return describedValue(*this, juce::AccessibilityRole::staticText, [this] {
        juce::StringArray parts;
        for (const Count& count : counts)
            parts.add(juce::String(count.modes) + " " + count.name);
        return parts.joinIntoString(", ");
    });
}

void QualityPage::Counts::paint(juce::Graphics& g) {
    auto area = getLocalBounds().reduced(0, gap);
    const int width = area.getWidth() / static_cast<int>(counts.size());
    for (const Count& count : counts) {
        auto tile = area.removeFromLeft(width).reduced(2, 0);
        g.setColour(colourOf(*this, LookColour::background));
        g.fillRoundedRectangle(tile.toFloat(), 5);
        g.setColour(colourOf(*this, LookColour::text));
        g.setFont(Look::headingFont(16));
        g.drawText(juce::String(count.modes), tile.removeFromTop(21).translated(0, 2),
                   juce::Justification::centred, false);
        g.setColour(colourOf(*this, LookColour::dimText));
        g.setFont(Look::textFont(11.5f));
        g.drawText(count.name, tile, juce::Justification::centred, false);
    }
}

QualityPage::QualityPage(ProcessorView& view) : DeckPage("Quality"), columns(groups(), view) {
    for (auto* child : std::initializer_list<juce::Component*>{&columns, &counts, &ramp, &meters})
        addAndMakeVisible(child);
}

void QualityPage::showSound(const SoundFrame& frame) {
    counts.show(frame);
    ramp.show(frame);
    meters.show(frame);
}

void QualityPage::resized() {
    auto area = getLocalBounds().reduced(padding);
    columns.setBounds(area.removeFromTop(getHeight() < heightForTall ? columnsHeight + 12
                                                                     : tallColumnsHeight + 12));
    counts.setBounds(area.removeFromTop(countHeight + 2 * gap));
    meters.setBounds(area.removeFromBottom(metersHeight));
    area.removeFromBottom(2);
    ramp.setBounds(area);
}

} // namespace idiophone
