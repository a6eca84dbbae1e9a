// Which MIDI controllers move which parameters, and how they learn to.
#pragma once

#include "Parameters/ParameterTable.h"

#include <optional>

namespace idiophone {

/// For the message thread. A parameter has at most one controller, on any channel; a controller may
/// move several. Controllers that have a function, such as the sustain pedal, keep it.
class MidiLearnView {
public:
    virtual ~MidiLearnView() = default;

    /// The controller's number, if there is one.
    virtual std::optional<int> controllerOf(ParameterId parameter) const = 0;

    /// The next controller that arrives moves the parameter, from then on. Bank selection (0, 32)
    /// and channel modes (120 to 127) are not learned: hosts send them unasked.
    virtual void learnController(ParameterId parameter) = 0;
    /// The parameter that waits for its controller, if one does.
    virtual std::optional<ParameterId> learningParameter() const = 0;
    virtual void stopLearning() = 0;

    virtual void forgetController(ParameterId parameter) = 0;
};

} // namespace idiophone
