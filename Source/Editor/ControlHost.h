// The services of the window that controls of parameters use.
#pragma once

#include "Parameters/ParameterTable.h"

#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

/// A parent component implements it. For the message thread.
class ControlHost {
public:
    virtual ~ControlHost() = default;

    /// How figures of physics are shown and typed now.
    virtual ValueDisplay valueDisplay() const = 0;
    /// Shows the list of the MIDI controllers that parameters have learned.
    virtual void showControllers() = 0;
};

/// The display of the host around a component; plain without one.
inline ValueDisplay valueDisplayAround(const juce::Component& part) {
    const auto* host = part.findParentComponentOfClass<ControlHost>();
    return host == nullptr ? ValueDisplay::plain : host->valueDisplay();
}

} // namespace idiophone
