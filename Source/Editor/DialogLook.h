// The product's look for what does not belong to the editor: file choosers, message boxes, and the
// standalone's own window and audio settings.
#pragma once

#include "Editor/Look.h"

namespace idiophone {

/// Shared by the windows of a process as a `juce::SharedResourcePointer`; the last scheme holds.
/// For the message thread.
class DialogLook {
public:
    DialogLook() { juce::LookAndFeel::setDefaultLookAndFeel(&look); }
    DialogLook(const DialogLook&) = delete;
    DialogLook& operator=(const DialogLook&) = delete;
    ~DialogLook() { juce::LookAndFeel::setDefaultLookAndFeel(nullptr); }

    void setScheme(LookScheme scheme) {
        look.setScheme(scheme);
        juce::LookAndFeel::setDefaultLookAndFeel(&look); // tells all windows
    }

private:
    Look look;
};

} // namespace idiophone
