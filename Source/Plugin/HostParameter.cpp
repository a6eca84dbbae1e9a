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
    movedByController =
        false; // first, so that a controller's move meanwhile still reaches the host
    exact = row.clamped(value);
    ++timesSet;
}

void HostParameter::moveByController(double value) noexcept {
    setExactValue(value);
    movedByController = true;
}

void HostParameter::tellHost() {
    if (!movedByController.exchange(false))
        return;
    beginGesture();
    tellListeners();
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
    tellListeners();
}

void HostParameter::changeByHand(double value) {
    beginGesture();
    setByHand(value);
    endGesture();
}

void HostParameter::tellListeners() {
    const float now = getValue();
    told = now;
    sendValueChangedMessageToListeners(now);
}

void HostParameter::tellListenersIfMoved() {
    if (const float last = told; last >= 0 && last != getValue())
        tellListeners();
}

void HostParameter::setValue(float normalised) {
    if (movedByController && normalised == told)
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
