// The button that changes between the dark and the light look.
#pragma once

#include "Editor/Look.h"
#include "Editor/Utf8.h"

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

class LookButton final : public juce::TextButton {
public:
    LookButton() {
        onClick = [this] {
            onLook(shown == LookScheme::dark ? LookScheme::light : LookScheme::dark);
        };
    }

    /// Called with the look that is wanted.
    std::function<void(LookScheme)> onLook;

    void show(LookScheme scheme) {
        shown = scheme;
        const bool dark = scheme == LookScheme::dark;
        setButtonText(fromUtf8(dark ? "\xe2\x98\xbe" : "\xe2\x98\x80"));
        setTitle(dark ? "Light look" : "Dark look");
        setTooltip(dark ? "Change to the light look" : "Change to the dark look");
    }

private:
    LookScheme shown = LookScheme::dark;
};

} // namespace idiophone
