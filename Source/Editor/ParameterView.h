// The window's view of the parameters.
#pragma once

#include "Parameters/ParameterTable.h"

namespace idiophone {

/// For the message thread.
class ParameterView {
public:
    virtual ~ParameterView() = default;

    /// The value in the parameter table's unit.
    virtual double value(ParameterId parameter) const = 0;
    /// The value in effect. For a figure of a material or mallet, that of the selected one, or of
    /// the objects' own material.
    virtual double effectiveValue(ParameterId parameter) const = 0;
    /// Returns the value that a reset gives: the one in effect when the preset was loaded. A setup
    /// parameter (ParameterInfo::isSetup) is reset to the table's default.
    virtual double presetValue(ParameterId parameter) const = 0;
    /// Call before changing a figure of a material or mallet by hand: copies all its figures to the
    /// custom one and selects that. Does nothing if the custom one is selected, or for other
    /// parameters.
    virtual void makeCustom(ParameterId figure) = 0;
    /// False if the parameter has no effect on the current sound: its objects would need a new
    /// analysis, or no key has a pitch to keep.
    virtual bool isLive(ParameterId parameter) const = 0;
    /// False if the parameter never has an effect in this plugin, because nothing comes in or there
    /// is one output only. Windows leave it out.
    virtual bool isOffered(ParameterId parameter) const = 0;
    /// A gesture by hand: `beginChange`, any number of `change`s, `endChange`. The host records it.
    virtual void beginChange(ParameterId parameter) = 0;
    virtual void change(ParameterId parameter, double value) = 0;
    virtual void endChange(ParameterId parameter) = 0;
    /// Changes the parameter in a gesture of its own. A figure's custom material or mallet is
    /// selected.
    void changeOnce(ParameterId parameter, double value) {
        beginChange(parameter);
        makeCustom(parameter);
        change(parameter, value);
        endChange(parameter);
    }
    /// Ends all open gestures. Call it when the window has closed.
    virtual void endAllChanges() = 0;
};

} // namespace idiophone
