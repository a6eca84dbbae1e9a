// What was done to the sound since it was opened, step by step, to be taken back and done again.
#pragma once

#include <string>

namespace idiophone {

/// For the message thread. A step is one gesture or typed value, all parameters of one edit, a
/// preset or object that was loaded, a mutation, a comparison. What a host does is no step, and
/// when it loads a state or program the steps before are forgotten: they belong to another sound.
class EditHistory {
public:
    virtual ~EditHistory() = default;

    virtual bool canUndo() = 0;
    virtual bool canRedo() = 0;
    /// What the next one would take back or do again ("Density"); empty where there is none.
    virtual std::string undoName() = 0;
    virtual std::string redoName() = 0;
    /// What rings goes on or fades as when it was changed by hand; where there is no step, nothing
    /// happens.
    virtual void undo() = 0;
    virtual void redo() = 0;

    /// The parameters that change by hand up to the matching `endEdit` are one step of this name.
    /// Edits nest; the outermost counts.
    virtual void beginEdit(const std::string& name) = 0;
    virtual void endEdit() = 0;
};

} // namespace idiophone
