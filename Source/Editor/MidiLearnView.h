// The MIDI controllers of parameters, and how to learn them.
#pragma once

#include "Parameters/ParameterTable.h"

#include <optional>

namespace idiophone {

/// For the message thread. A parameter has at most one controller, on any channel. A controller may
/// move several parameters. Controllers with a function, such as the sustain pedal, keep it.
class MidiLearnView {
public:
    virtual ~MidiLearnView() = default;

    virtual std::optional<int> controllerOf(ParameterId parameter) const = 0;

    /// Assigns the next controller that arrives to the parameter. Bank select (0, 32) and channel
    /// modes (120 to 127) are not learned: hosts send them unasked.
    virtual void learnController(ParameterId parameter) = 0;
    /// The parameter whose controller is pending, or nothing.
    virtual std::optional<ParameterId> learningParameter() const = 0;
    virtual void stopLearning() = 0;

    virtual void forgetController(ParameterId parameter) = 0;
};

} // namespace idiophone
