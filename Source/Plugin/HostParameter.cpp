#include "Plugin/HostParameter.h"

#include "Editor/Utf8.h"

#include <algorithm>

namespace idiophone {
namespace {

// The host shows the label behind the text.
juce::String withoutUnit(const std::string& text, const ParameterInfo& info) {
    const auto full = fromUtf8(text);
    const auto suffix = " " + fromUtf8(info.unit);
    return *info.unit != '\0' && full.endsWith(suffix) ? full.dropLastCharacters(suffix.length())
                                                       : full;
}

} // namespace

HostParameter::HostParameter(const ParameterInfo& info)
    : AudioProcessorParameterWithID(
          juce::ParameterID(info.id, info.versionAdded),
          fromUtf8(info.name),
          juce::AudioProcessorParameterWithIDAttributes().withLabel(fromUtf8(info.unit))),
      row(info), exact(info.defaultValue) {}

float HostParameter::getValue() const {
    return static_cast<float>(row.toNormalised(exactValue()));
}

void HostParameter::setExactValue(double value) noexcept {
    // First: if a controller moves it meanwhile, the host must get that value.
    movedByController = false;
    exact = row.clamped(value);
    ++timesSet;
}

double HostParameter::modulatedValue() const noexcept {
    return modulationShare == 0 ? exactValue() : row.fromNormalised(modulatedNormalised());
}

double HostParameter::normalisedWith(double share) const noexcept {
    return std::clamp(row.toNormalised(exactValue()) + share, 0.0, 1.0);
}

void HostParameter::moveByController(double value) noexcept {
    setExactValue(value);
    movedByController = true;
}

void HostParameter::sendControllerMove() {
    if (!movedByController.exchange(false))
        return;
    beginGesture();
    sendValue();
    endGesture();
}

void HostParameter::beginGesture() {
    if (openGestures++ == 0)
        beginChangeGesture();
}

bool HostParameter::endGesture() {
    if (openGestures == 0 || --openGestures > 0)
        return false;
    endChangeGesture();
    return true;
}

void HostParameter::endAllGestures() {
    openGestures = std::min(openGestures, 1);
    endGesture();
}

void HostParameter::setByHand(double value) {
    setExactValue(value);
    sendValue();
}

void HostParameter::changeByHand(double value) {
    beginGesture();
    setByHand(value);
    endGesture();
}

void HostParameter::sendValue() {
    const float now = getValue();
    lastSent = now;
    sendValueChangedMessageToListeners(now);
}

void HostParameter::sendValueIfMoved() {
    if (const float last = lastSent; last >= 0 && last != getValue())
        sendValue();
}

void HostParameter::setValue(float normalised) {
    if (movedByController && normalised == lastSent)
        return;
    if (normalised != getValue())
        setExactValue(row.fromNormalised(normalised));
}

float HostParameter::getDefaultValue() const {
    return static_cast<float>(row.toNormalised(row.defaultValue));
}

juce::String HostParameter::getText(float normalised, int maximumLength) const {
    const auto text = withoutUnit(formatParameter(row, row.fromNormalised(normalised)), row);
    return maximumLength > 0 ? text.substring(0, maximumLength) : text;
}

float HostParameter::getValueForText(const juce::String& text) const {
    const auto parsed = parseParameter(row, text.toStdString());
    return parsed ? static_cast<float>(row.toNormalised(*parsed)) : getValue();
}

bool HostParameter::isDiscrete() const {
    return row.scale == ParameterScale::steps || row.scale == ParameterScale::onOff ||
           row.scale == ParameterScale::choice;
}

bool HostParameter::isBoolean() const {
    return row.scale == ParameterScale::onOff;
}

int HostParameter::getNumSteps() const {
    return isDiscrete() ? static_cast<int>(row.maximum - row.minimum) + 1
                        : AudioProcessorParameterWithID::getNumSteps();
}

} // namespace idiophone
