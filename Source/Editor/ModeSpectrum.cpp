#include "Editor/ModeSpectrum.h"

#include "Editor/Look.h"
#include "Editor/ModeText.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace idiophone {
namespace {

constexpr float left = 32, right = 6, top = 6, axisHeight = 15, footHeight = 6;
constexpr float leastTickGap = 26, reach = 12;
constexpr int leastLine = 4; // of what is silent

/// The loudest are drawn last and can be seen.
constexpr std::array drawn{ModeStanding::outOfBand, ModeStanding::belowTau, ModeStanding::silenced,
                           ModeStanding::beyondBudget, ModeStanding::sounding};

} // namespace

ModeSpectrum::ModeSpectrum(SoundView& soundView) : view(soundView), scale({}, {}, {}) {
    setTitle("Modes");
    setDescription("Arrows choose a mode, M mutes it, S lets it be heard alone");
    setTooltip("Click a mode to mute it, Alt-click to hear it alone");
    setWantsKeyboardFocus(true);
}

juce::Rectangle<float> ModeSpectrum::levelArea() const {
    const auto plot = getLocalBounds().toFloat();
    return {left, top, std::max(plot.getWidth() - left - right, 1.0f),
            std::max(decayArea().getY() - footHeight - 4 - top, 1.0f)};
}

juce::Rectangle<float> ModeSpectrum::decayArea() const {
    const auto plot = getLocalBounds().toFloat();
    const float height = std::clamp(plot.getHeight() / 4, 24.0f, 90.0f);
    return {left, plot.getHeight() - axisHeight - height,
            std::max(plot.getWidth() - left - right, 1.0f), height};
}

SpectrumScale ModeSpectrum::scaleOf(const SoundFrame& shown) const {
    std::vector<double> frequencies;
    for (const ModeNow& mode : shown.modes)
        if (mode.standing != ModeStanding::outOfBand)
            frequencies.push_back(static_cast<double>(mode.frequencyHz));
    return {frequencies, levelArea(), decayArea()};
}

std::vector<ModeSpectrum::Line> ModeSpectrum::linesOf(const SoundFrame& shown) const {
    std::vector<Line> result;
    result.reserve(shown.modes.size());
    const int foot = juce::roundToInt(levelArea().getBottom());
    for (const ModeNow& mode : shown.modes) {
        const double decibels = decibelsOf(static_cast<double>(mode.amplitude));
        result.push_back(
            {.x = juce::roundToInt(scale.x(static_cast<double>(mode.frequencyHz))),
             .top = std::min(juce::roundToInt(scale.levelY(decibels)), foot - leastLine),
             .decayY = juce::roundToInt(scale.decayY(static_cast<double>(mode.t60Seconds))),
             .group = mode.group,
             .standing = mode.standing,
             .isMuted = mode.isMuted,
             .isHeardAlone = mode.isHeardAlone});
    }
    return result;
}

void ModeSpectrum::show(const SoundFrame& next) {
    const bool isOther = next.object != frame.object ||
                         next.instrumentNumber != frame.instrumentNumber ||
                         next.modes.size() != frame.modes.size();
    frame = next;
    if (isOther)
        hovered = chosen = std::nullopt;
    scale = scaleOf(frame);
    auto nextLines = linesOf(frame);
    const int nextTau = juce::roundToInt(scale.levelY(decibelsOf(frame.tauMetresPerSecond)));
    const bool looksOther = isOther || nextTau != tauY || nextLines != lines;
    lines = std::move(nextLines);
    tauY = nextTau;
    if (looksOther)
        repaint();
    if (onModeShown && (isOther || modeShown()))
        onModeShown();
}

std::optional<std::size_t> ModeSpectrum::modeShown() const {
    return hovered ? hovered : chosen;
}

void ModeSpectrum::choose(std::optional<std::size_t> mode) {
    if (mode && *mode >= frame.modes.size())
        return;
    chosen = mode;
    modeChanged();
}

void ModeSpectrum::hover(std::optional<std::size_t> mode) {
    if (mode == hovered)
        return;
    hovered = mode;
    modeChanged();
}

void ModeSpectrum::modeChanged() {
    repaint();
    if (onModeShown)
        onModeShown();
    if (auto* handler = getAccessibilityHandler())
        handler->notifyAccessibilityEvent(juce::AccessibilityEvent::valueChanged);
}

void ModeSpectrum::toggleMute(std::size_t mode) {
    if (mode >= frame.modes.size() || frame.object < 0)
        return;
    bool& muted = frame.modes[mode].isMuted;
    if (view.muteMode(static_cast<std::size_t>(frame.object), static_cast<std::int32_t>(mode),
                      !muted))
        muted = !muted;
    lines = linesOf(frame);
    modeChanged();
}

void ModeSpectrum::toggleAlone(std::size_t mode) {
    if (mode >= frame.modes.size() || frame.object < 0)
        return;
    bool& alone = frame.modes[mode].isHeardAlone;
    if (view.hearModeAlone(static_cast<std::size_t>(frame.object), static_cast<std::int32_t>(mode),
                           !alone))
        alone = !alone;
    lines = linesOf(frame);
    modeChanged();
}

/// The nearest in frequency, of several the one whose end is nearest.
std::optional<std::size_t> ModeSpectrum::modeAt(juce::Point<float> position) const {
    std::optional<std::size_t> nearest;
    float least = reach * reach;
    for (std::size_t mode = 0; mode < lines.size(); ++mode) {
        const auto away = position - juce::Point(lines[mode].x, lines[mode].top).toFloat();
        const float along = std::max(std::abs(away.y) - 2 * reach, 0.0f) / 20;
        if (const float distance = away.x * away.x + along * along; distance < least) {
            least = distance;
            nearest = mode;
        }
    }
    return nearest;
}

void ModeSpectrum::mouseMove(const juce::MouseEvent& event) {
    hover(modeAt(event.position));
}

void ModeSpectrum::mouseExit(const juce::MouseEvent&) {
    hover(std::nullopt);
}

void ModeSpectrum::mouseDown(const juce::MouseEvent& event) {
    const auto mode = modeAt(event.position);
    if (!mode || !event.mods.isLeftButtonDown())
        return;
    chosen = mode;
    if (event.mods.isAltDown())
        toggleAlone(*mode);
    else
        toggleMute(*mode);
}

bool ModeSpectrum::keyPressed(const juce::KeyPress& key) {
    const std::size_t count = frame.modes.size();
    if (count == 0)
        return false;
    const auto character = juce::CharacterFunctions::toLowerCase(key.getTextCharacter());
    if (key == juce::KeyPress::rightKey || key == juce::KeyPress::upKey)
        choose(chosen ? std::min(*chosen + 1, count - 1) : 0);
    else if (key == juce::KeyPress::leftKey || key == juce::KeyPress::downKey)
        choose(chosen && *chosen > 0 ? *chosen - 1 : 0);
    else if (key == juce::KeyPress::homeKey)
        choose(0);
    else if (key == juce::KeyPress::endKey)
        choose(count - 1);
    else if (key == juce::KeyPress::escapeKey && chosen)
        choose(std::nullopt);
    else if (character == 'm' && chosen)
        toggleMute(*chosen);
    else if (character == 's' && chosen)
        toggleAlone(*chosen);
    else
        return false;
    return true;
}

void ModeSpectrum::resized() {
    scale = scaleOf(frame);
    lines = linesOf(frame);
    tauY = juce::roundToInt(scale.levelY(decibelsOf(frame.tauMetresPerSecond)));
}

juce::String ModeSpectrum::description() const {
    const auto mode = modeShown();
    return mode ? describeMode(frame, *mode).joinIntoString(", ")
                : juce::String(frame.modes.size()) + " modes";
}

std::unique_ptr<juce::AccessibilityHandler> ModeSpectrum::createAccessibilityHandler() {
    class Value final : public juce::AccessibilityTextValueInterface {
    public:
        explicit Value(ModeSpectrum& shown) : spectrum(shown) {}
        bool isReadOnly() const override { return true; }
        juce::String getCurrentValueAsString() const override { return spectrum.description(); }
        void setValueAsString(const juce::String&) override {}

    private:
        ModeSpectrum& spectrum;
    };
    return std::make_unique<juce::AccessibilityHandler>(
        *this, juce::AccessibilityRole::slider, juce::AccessibilityActions{},
        juce::AccessibilityHandler::Interfaces{std::make_unique<Value>(*this)});
}

void ModeSpectrum::paintScale(juce::Graphics& g) const {
    const auto levels = levelArea();
    const auto decays = decayArea();
    g.setFont(Look::textFont(10.5f));
    const auto horizontal = [&](const SpectrumScale::Tick& tick, bool isLabelled) {
        g.setColour(colourOf(*this, LookColour::outline));
        g.fillRect(levels.getX(), tick.at, levels.getWidth(), 0.5f);
        g.setColour(colourOf(*this, LookColour::dimText));
        if (isLabelled)
            g.drawText(tick.text, juce::Rectangle<float>(0, tick.at - 6, left - 4, 12),
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
        const float centre = std::clamp(tick.at, left + 6, static_cast<float>(getWidth()) - 15);
        g.drawText(tick.text,
                   juce::Rectangle<float>(30, axisHeight)
                       .withCentre({centre, decays.getBottom() + axisHeight / 2 + 1}),
                   juce::Justification::centred, false);
    }
}

void ModeSpectrum::paintTau(juce::Graphics& g) const {
    const auto levels = levelArea();
    const float y = static_cast<float>(tauY) + 0.5f; // a row of pixels
    const std::array dashes{5.0f, 4.0f};
    g.setColour(colourOf(*this, LookColour::error));
    g.drawDashedLine({{levels.getX(), y}, {levels.getRight(), y}}, dashes.data(), 2, 1);
    g.setFont(Look::textFont(11.5f));
    g.drawText(juce::String::fromUTF8("\xcf\x84"),
               juce::Rectangle<float>(levels.getRight() - 12, y - 13, 12, 12),
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

/// A common foot under the modes that sound as one.
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
