#include "Plugin/MidiLearn.h"

namespace idiophone {

double controlledValue(const ParameterInfo& info, int controllerValue) noexcept {
    return info.fromNormalised(controllerValue / 127.0);
}

MidiLearn::MidiLearn() {
    for (auto& number : numbers)
        number = noController;
}

void MidiLearn::follow(juce::MidiBufferIterator first,
                       juce::MidiBufferIterator last,
                       const HostParameters& parameters) noexcept {
    std::array<std::int8_t, 128> values;
    values.fill(nothing);
    for (; first != last; ++first) {
        const auto message = *first;
        if (message.numBytes != 3 || (message.data[0] & 0xf0) != 0xb0)
            continue;
        const int number = message.data[1] & 0x7f;
        values[static_cast<std::size_t>(number)] = static_cast<std::int8_t>(message.data[2] & 0x7f);
        if (int waiting = learning; waiting != nothing && isMeantToBeLearned(number) &&
                                    learning.compare_exchange_strong(waiting, nothing)) {
            numbers[static_cast<std::size_t>(waiting)] = static_cast<std::int8_t>(number);
            reassigned = true;
        }
    }
    for (const auto& info : parameterTable()) {
        const int number = numbers[static_cast<std::size_t>(info.parameter)];
        if (number == noController || values[static_cast<std::size_t>(number)] == nothing)
            continue;
        parameters[info.parameter].moveByController(
            controlledValue(info, values[static_cast<std::size_t>(number)]));
    }
}

ControllerAssignments MidiLearn::assignments() const noexcept {
    ControllerAssignments result;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        result.numbers[i] = numbers[i];
    return result;
}

void MidiLearn::assign(const ControllerAssignments& assignments) noexcept {
    learning = nothing;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = assignments.numbers[i];
}

std::optional<int> MidiLearn::controllerOf(ParameterId parameter) const {
    const int number = numbers[static_cast<std::size_t>(parameter)];
    return number == noController ? std::nullopt : std::optional(number);
}

std::optional<ParameterId> MidiLearn::learningParameter() const {
    const int waiting = learning;
    return waiting == nothing ? std::nullopt : std::optional(static_cast<ParameterId>(waiting));
}

void MidiLearn::forgetController(ParameterId parameter) {
    numbers[static_cast<std::size_t>(parameter)] = noController;
    reassigned = true;
}

} // namespace idiophone
