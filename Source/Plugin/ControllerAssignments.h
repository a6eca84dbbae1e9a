// Stores which MIDI controller moves which parameter: plain data.
#pragma once

#include "Parameters/ParameterTable.h"

#include <array>
#include <cstdint>

namespace idiophone {

inline constexpr int noController = -1;

/// Returns whether a controller number may be assigned: not bank selection or channel modes.
constexpr bool isLearnable(int number) {
    return number > 0 && number < 120 && number != 32;
}

/// Returns whether a controller that moves during MIDI learn is assigned. Excludes the controllers
/// of registered parameters, because keyboards send them unasked.
constexpr bool isMeantToBeLearned(int number) {
    return isLearnable(number) && number != 6 && number != 38 && (number < 96 || number > 101);
}

struct ControllerAssignments {
    /// A learnable number for each parameter, or `noController`.
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

} // namespace idiophone
