#include "Editor/ModeSpectrum.h"

#include "Editor/DescribedValue.h"
#include "Editor/ModeText.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

constexpr float left = 32, right = 6, top = 6, axisHeight = 15, footHeight = 6;
constexpr float reach = 12;
constexpr int leastLine = 4; // pixels, for silent modes

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
    const int nextTau = juce::roundToInt(scale.levelY(decibelsOf(frame.tauPascals)));
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

/// The nearest mode in frequency. Of several, the one whose line ends nearest.
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
    const bool isCommanded = key.getModifiers().isCommandDown() || key.getModifiers().isCtrlDown();
    const auto character =
        isCommanded ? 0 : juce::CharacterFunctions::toLowerCase(key.getTextCharacter());
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

bool ModeSpectrum::keyStateChanged(bool) {
    return juce::JUCEApplicationBase::isStandaloneApp(); // in a plugin, pass keys on to the host
}

void ModeSpectrum::resized() {
    scale = scaleOf(frame);
    lines = linesOf(frame);
    tauY = juce::roundToInt(scale.levelY(decibelsOf(frame.tauPascals)));
}

juce::String ModeSpectrum::description() const {
    const auto mode = modeShown();
    return mode ? describeMode(frame, *mode).joinIntoString(", ")
                : juce::String(frame.modes.size()) + " modes";
}

std::unique_ptr<juce::AccessibilityHandler> ModeSpectrum::createAccessibilityHandler() {
    return describedValue(*this, juce::AccessibilityRole::slider, [this] { return description(); });
}

} // namespace idiophone
