// Draws the spectrum of modes.
#include "Editor/Look.h"
#include "Editor/ModeSpectrum.h"
#include "Editor/Utf8.h"

#include <algorithm>
#include <array>

namespace idiophone {
namespace {

constexpr float leastTickGap = 26;

/// Drawing order: sounding modes last, so that they stay visible.
constexpr std::array drawn{ModeStanding::outOfBand, ModeStanding::belowTau, ModeStanding::silenced,
                           ModeStanding::beyondBudget, ModeStanding::sounding};

} // namespace

void ModeSpectrum::paintScale(juce::Graphics& g) const {
    const auto levels = levelArea();
    const auto decays = decayArea();
    const auto axis = getLocalBounds().toFloat().withTop(decays.getBottom());
    g.setFont(Look::textFont(10.5f));
    const auto horizontal = [&](const SpectrumScale::Tick& tick, bool isLabelled) {
        g.setColour(colourOf(*this, LookColour::outline));
        g.fillRect(levels.getX(), tick.at, levels.getWidth(), 0.5f);
        g.setColour(colourOf(*this, LookColour::dimText));
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
    for (const auto& tick : scale.frequencyTicks(leastTickGap)) {
        g.setColour(colourOf(*this, LookColour::outline));
        g.fillRect(tick.at, levels.getY(), 0.5f, decays.getBottom() - levels.getY());
        g.setColour(colourOf(*this, LookColour::dimText));
        const float centre =
            std::clamp(tick.at, levels.getX() + 6, static_cast<float>(getWidth()) - 15);
        g.drawText(tick.text,
                   juce::Rectangle<float>(30, axis.getHeight())
                       .withCentre({centre, axis.getCentreY() + 1}),
                   juce::Justification::centred, false);
    }
}

void ModeSpectrum::paintTau(juce::Graphics& g) const {
    const auto levels = levelArea();
    const float y = static_cast<float>(tauY) + 0.5f; // centre of a pixel row
    const std::array dashes{5.0f, 4.0f};
    g.setColour(colourOf(*this, LookColour::error));
    g.drawDashedLine({{levels.getX(), y}, {levels.getRight(), y}}, dashes.data(), 2, 1);
    g.setFont(Look::textFont(11.5f));
    g.drawText(fromUtf8("\xcf\x84"), juce::Rectangle<float>(levels.getRight() - 12, y - 13, 12, 12),
               juce::Justification::centred, false);
}

juce::Colour ModeSpectrum::colourFor(const Line& line) const {
    switch (line.standing) {
    case ModeStanding::sounding:
        return colourOf(*this, LookColour::accent);
    case ModeStanding::beyondBudget:
        return colourOf(*this, LookColour::text);
    case ModeStanding::silenced:
        return colourOf(*this, LookColour::dimText);
    case ModeStanding::belowTau:
        return colourOf(*this, LookColour::dimText).withMultipliedAlpha(0.55f);
    case ModeStanding::outOfBand:
        break;
    }
    return colourOf(*this, LookColour::outline);
}

/// Draws a common base under modes that are merged into one.
void ModeSpectrum::paintGroups(juce::Graphics& g) const {
    const float foot = levelArea().getBottom() + 3;
    for (std::size_t first = 0; first < lines.size();) {
        std::size_t end = first + 1;
        while (end < lines.size() && lines[end].group == lines[first].group)
            ++end;
        if (end - first > 1) {
            const auto [least, most] = std::minmax(lines[first].x, lines[end - 1].x);
            g.setColour(colourFor(lines[first]));
            g.fillRect(static_cast<float>(least) - 2, foot, static_cast<float>(most - least) + 4,
                       2.5f);
        }
        first = end;
    }
}

void ModeSpectrum::paintLine(juce::Graphics& g, const Line& line, bool isShown) const {
    const auto colour = isShown ? colourOf(*this, LookColour::text) : colourFor(line);
    const auto x = static_cast<float>(line.x);
    const auto lineTop = static_cast<float>(line.top);
    const float foot = levelArea().getBottom();
    const float width = isShown ? 4.0f : 2.0f;
    g.setColour(colour);
    if (line.standing == ModeStanding::beyondBudget || line.standing == ModeStanding::silenced) {
        const std::array dashes{2.0f, 2.0f};
        g.drawDashedLine({{x, foot}, {x, lineTop}}, dashes.data(), 2, width);
    } else {
        g.fillRect(x - width / 2, lineTop, width, foot - lineTop);
    }
    const float dot = isShown ? 3.0f : 1.7f;
    g.fillEllipse(x - dot, static_cast<float>(line.decayY) - dot, 2 * dot, 2 * dot);
    if (line.isMuted) {
        g.setColour(colourOf(*this, LookColour::error));
        g.drawLine(x - 3.5f, lineTop - 8, x + 3.5f, lineTop - 1, 1.5f);
        g.drawLine(x - 3.5f, lineTop - 1, x + 3.5f, lineTop - 8, 1.5f);
    }
    if (line.isHeardAlone) {
        g.setColour(colourOf(*this, LookColour::accent));
        g.fillEllipse(x - 3.5f, lineTop - (line.isMuted ? 17 : 9), 7, 7);
    }
}

void ModeSpectrum::paint(juce::Graphics& g) {
    g.setColour(colourOf(*this, LookColour::background));
    g.fillRoundedRectangle(getLocalBounds().toFloat(), 5);
    g.setColour(
        colourOf(*this, hasKeyboardFocus(false) ? LookColour::accent : LookColour::outline));
    g.drawRoundedRectangle(getLocalBounds().toFloat().reduced(0.5f), 5, 1);
    paintScale(g);
    const auto shown = modeShown();
    if (shown && *shown < lines.size()) {
        g.setColour(colourOf(*this, LookColour::outline));
        g.fillRect(static_cast<float>(lines[*shown].x) - 2.5f, levelArea().getY(), 5.0f,
                   decayArea().getBottom() - levelArea().getY());
    }
    paintGroups(g);
    for (const ModeStanding standing : drawn)
        for (std::size_t mode = 0; mode < lines.size(); ++mode)
            if (lines[mode].standing == standing && mode != shown)
                paintLine(g, lines[mode], false);
    if (shown && *shown < lines.size())
        paintLine(g, lines[*shown], true);
    paintTau(g);
}

} // namespace idiophone
