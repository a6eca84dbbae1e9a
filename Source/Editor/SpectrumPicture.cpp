#include "Editor/SpectrumPicture.h"

#include "Editor/Look.h"
#include "Editor/ModeText.h"
#include "Editor/Utf8.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace idiophone {
namespace {

constexpr float left = 32, right = 6, top = 6, axisHeight = 15, footHeight = 6;
constexpr int minimumLine = 4; // pixels, for silent modes

/// Drawing order: sounding modes last, so that they stay visible.
constexpr std::array order{ModeStanding::outOfBand, ModeStanding::belowTau, ModeStanding::silenced,
                           ModeStanding::beyondBudget, ModeStanding::sounding};

SpectrumScale scaleOf(const SoundFrame& frame, juce::Rectangle<float> bounds) {
    std::vector<double> frequencies;
    for (const ModeNow& mode : frame.modes)
        if (mode.standing != ModeStanding::outOfBand)
            frequencies.push_back(static_cast<double>(mode.frequencyHz));
    const float width = std::max(bounds.getWidth() - left - right, 1.0f);
    const float height = std::clamp(bounds.getHeight() / 4, 24.0f, 90.0f);
    const float decayTop = bounds.getHeight() - axisHeight - height;
    return {frequencies,
            {left, top, width, std::max(decayTop - footHeight - 4 - top, 1.0f)},
            {left, decayTop, width, height}};
}

juce::Colour colourFor(const juce::Component& component, ModeStanding standing) {
    switch (standing) {
    case ModeStanding::sounding:
        return colourOf(component, LookColour::accent);
    case ModeStanding::beyondBudget:
        return colourOf(component, LookColour::text);
    case ModeStanding::silenced:
        return colourOf(component, LookColour::dimText);
    case ModeStanding::belowTau:
        return colourOf(component, LookColour::dimText).withMultipliedAlpha(0.55f);
    case ModeStanding::outOfBand:
        break;
    }
    return colourOf(component, LookColour::outline);
}

void paintScale(juce::Graphics& g, const juce::Component& component, const SpectrumScale& scale) {
    constexpr float minimumTickGap = 26;
    const auto levels = scale.levels();
    const auto decays = scale.decays();
    const auto axis = component.getLocalBounds().toFloat().withTop(decays.getBottom());
    const auto outline = colourOf(component, LookColour::outline);
    const auto dimText = colourOf(component, LookColour::dimText);
    g.setFont(Look::textFont(10.5f));
    const auto horizontal = [&](const SpectrumScale::Tick& tick, bool isLabelled) {
        g.setColour(outline);
        g.fillRect(levels.getX(), tick.at, levels.getWidth(), 0.5f);
        g.setColour(dimText);
        if (isLabelled)
            g.drawText(tick.text, juce::Rectangle<float>(0, tick.at - 6, levels.getX() - 4, 12),
                       juce::Justification::centredRight, false);
    };
    const auto levelTicks = scale.levelTicks();
    const bool isCrowded = levels.getHeight() < 12 * static_cast<float>(levelTicks.size());
    for (std::size_t k = 0; k < levelTicks.size(); ++k)
        horizontal(levelTicks[k], !isCrowded || k % 2 == 0);
    for (const auto& tick : scale.decayTicks())
        horizontal(tick, decays.getHeight() > 40 || !tick.text.startsWith("10"));
    for (const auto& tick : scale.frequencyTicks(minimumTickGap)) {
        g.setColour(outline);
        g.fillRect(tick.at, levels.getY(), 0.5f, decays.getBottom() - levels.getY());
        g.setColour(dimText);
        const float centre = std::clamp(tick.at, levels.getX() + 6, axis.getRight() - 15);
        g.drawText(tick.text,
                   juce::Rectangle<float>(30, axis.getHeight())
                       .withCentre({centre, axis.getCentreY() + 1}),
                   juce::Justification::centred, false);
    }
}

} // namespace

bool SpectrumPicture::update(const SoundFrame& frame, juce::Rectangle<int> bounds) {
    scale = scaleOf(frame, bounds.toFloat());
    std::vector<Line> newLines;
    newLines.reserve(frame.modes.size());
    const int foot = juce::roundToInt(scale.levels().getBottom());
    for (const ModeNow& mode : frame.modes) {
        const double decibels = decibelsOf(static_cast<double>(mode.amplitude));
        newLines.push_back(
            {.x = juce::roundToInt(scale.x(static_cast<double>(mode.frequencyHz))),
             .top = std::min(juce::roundToInt(scale.levelY(decibels)), foot - minimumLine),
             .decayY = juce::roundToInt(scale.decayY(static_cast<double>(mode.t60Seconds))),
             .group = mode.group,
             .standing = mode.standing,
             .isMuted = mode.isMuted,
             .isHeardAlone = mode.isHeardAlone});
    }
    const int newTauY = juce::roundToInt(scale.levelY(decibelsOf(frame.tauPascals)));
    const bool isOther = newTauY != tauY || newLines != lines;
    lines = std::move(newLines);
    tauY = newTauY;
    return isOther;
}

std::optional<std::size_t> SpectrumPicture::modeAt(juce::Point<float> position) const {
    constexpr float reach = 12;
    std::optional<std::size_t> nearest;
    float nearestSquare = reach * reach;
    for (std::size_t mode = 0; mode < lines.size(); ++mode) {
        const auto away = position - juce::Point(lines[mode].x, lines[mode].top).toFloat();
        const float along = std::max(std::abs(away.y) - 2 * reach, 0.0f) / 20;
        if (const float square = away.x * away.x + along * along; square < nearestSquare) {
            nearestSquare = square;
            nearest = mode;
        }
    }
    return nearest;
}

void SpectrumPicture::paint(juce::Graphics& g,
                            const juce::Component& component,
                            std::optional<std::size_t> emphasised) const {
    const auto levels = scale.levels();
    const float foot = levels.getBottom();
    const auto colour = [&](LookColour role) { return colourOf(component, role); };
    const auto paintLine = [&](const Line& line, bool isEmphasised) {
        const auto x = static_cast<float>(line.x), lineTop = static_cast<float>(line.top);
        const float width = isEmphasised ? 4.0f : 2.0f, dot = isEmphasised ? 3.0f : 1.7f;
        g.setColour(isEmphasised ? colour(LookColour::text) : colourFor(component, line.standing));
        if (line.standing == ModeStanding::beyondBudget ||
            line.standing == ModeStanding::silenced) {
            const std::array dashes{2.0f, 2.0f};
            g.drawDashedLine({{x, foot}, {x, lineTop}}, dashes.data(), 2, width);
        } else {
            g.fillRect(x - width / 2, lineTop, width, foot - lineTop);
        }
        g.fillEllipse(x - dot, static_cast<float>(line.decayY) - dot, 2 * dot, 2 * dot);
        if (line.isMuted) {
            g.setColour(colour(LookColour::error));
            g.drawLine(x - 3.5f, lineTop - 8, x + 3.5f, lineTop - 1, 1.5f);
            g.drawLine(x - 3.5f, lineTop - 1, x + 3.5f, lineTop - 8, 1.5f);
        }
        if (line.isHeardAlone) {
            g.setColour(colour(LookColour::accent));
            g.fillEllipse(x - 3.5f, lineTop - (line.isMuted ? 17.0f : 9.0f), 7, 7);
        }
    };

    paintScale(g, component, scale);
    const bool emphasises = emphasised && *emphasised < lines.size();
    if (emphasises) {
        g.setColour(colour(LookColour::outline));
        g.fillRect(static_cast<float>(lines[*emphasised].x) - 2.5f, levels.getY(), 5.0f,
                   scale.decays().getBottom() - levels.getY());
    }
    // Modes that are merged into one have a common base.
    for (std::size_t first = 0, end = 0; first < lines.size(); first = end) {
        for (end = first + 1; end < lines.size() && lines[end].group == lines[first].group;)
            ++end;
        if (end - first == 1)
            continue;
        const auto [lowest, highest] = std::minmax(lines[first].x, lines[end - 1].x);
        g.setColour(colourFor(component, lines[first].standing));
        g.fillRect(static_cast<float>(lowest) - 2, foot + 3,
                   static_cast<float>(highest - lowest) + 4, 2.5f);
    }
    for (const ModeStanding standing : order)
        for (std::size_t mode = 0; mode < lines.size(); ++mode)
            if (lines[mode].standing == standing && mode != emphasised)
                paintLine(lines[mode], false);
    if (emphasises)
        paintLine(lines[*emphasised], true);

    const float y = static_cast<float>(tauY) + 0.5f; // centre of a pixel row
    const std::array dashes{5.0f, 4.0f};
    g.setColour(colour(LookColour::error));
    g.drawDashedLine({{levels.getX(), y}, {levels.getRight(), y}}, dashes.data(), 2, 1);
    g.setFont(Look::textFont(11.5f));
    g.drawText(fromUtf8("\xcf\x84"), juce::Rectangle<float>(levels.getRight() - 12, y - 13, 12, 12),
               juce::Justification::centred, false);
}

} // namespace idiophone
