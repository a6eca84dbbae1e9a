// Undo and redo of edits to the sound since it was opened.
#pragma once

#include <string>

namespace idiophone {

/// For the message thread. One step is a gesture, a typed value, an edit of several parameters, a
/// loaded preset or object, a mutation, or an A/B comparison. Host changes are not steps. If the
/// host loads a state or program, all steps are deleted, because they belong to another sound.
class EditHistory {
public:
    virtual ~EditHistory() = default;

    virtual bool canUndo() = 0;
    virtual bool canRedo() = 0;
    /// The name of the next step to undo or redo ("Density"); empty if there is none.
    virtual std::string undoName() = 0;
    virtual std::string redoName() = 0;
    /// Ringing sound continues or fades as after the same edit by hand. Does nothing if there is no
    /// step.
    virtual void undo() = 0;
    virtual void redo() = 0;

    /// All parameters that change by hand up to the matching `endEdit` form one step of this name.
    /// Edits nest; the outermost counts.
    virtual void beginEdit(const std::string& name) = 0;
    virtual void endEdit() = 0;
};

} // namespace idiophone
