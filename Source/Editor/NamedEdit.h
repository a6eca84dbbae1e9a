// Makes all changes by hand during its life one step of undo.
#pragma once

#include "Editor/EditHistory.h"

#include <string>

namespace idiophone {

/// For the message thread. Edits nest; the outermost names the step.
class NamedEdit {
public:
    NamedEdit(EditHistory& editHistory, const std::string& name) : history(editHistory) {
        history.beginEdit(name);
    }
    ~NamedEdit() { history.endEdit(); }
    NamedEdit(const NamedEdit&) = delete;
    NamedEdit& operator=(const NamedEdit&) = delete;

private:
    EditHistory& history;
};

} // namespace idiophone
