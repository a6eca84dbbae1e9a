// Which MIDI controller moves which parameter: plain data.
#pragma once

#include "Parameters/ParameterTable.h"

#include <array>
#include <cstdint>

namespace idiophone {

inline constexpr int noController = -1;

/// Whether a controller's number may be assigned: not those of bank selection and channel modes.
constexpr bool isLearnable(int number) {
    return number > 0 && number < 120 && number != 32;
}

/// Whether one that moves while a parameter learns is taken for it: not those of which MIDI makes
/// registered parameters, as controllers send them unasked.
constexpr bool isMeantToBeLearned(int number) {
    return isLearnable(number) && number != 6 && number != 38 && (number < 96 || number > 101);
}

struct ControllerAssignments {
    /// For each parameter a learnable number, or `noController`.
    std::array<std::int8_t, parameterCount> numbers = [] {
        std::array<std::int8_t, parameterCount> none{};
        none.fill(noController);
        return none;
    }();

    std::int8_t& operator[](ParameterId parameter) {
        return numbers[static_cast<std::size_t>(parameter)];
    }
    int operator[](ParameterId parameter) const {
        return numbers[static_cast<std::size_t>(parameter)];
    }

    bool operator==(const ControllerAssignments&) const = default;
};

/// The value that a controller at 0 to 127 stands for, evenly over the parameter's scale; of a
/// choice, over those that have a name. Neither allocates nor locks.
double controlledValue(const ParameterInfo& info, int controllerValue) noexcept;

} // namespace idiophone
