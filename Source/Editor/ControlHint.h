// Finds the hint for the status line: the tooltip of the control under the mouse, or of the control
// that the Tab key focused, whichever came last.
#pragma once

#include <juce_gui_basics/juce_gui_basics.h>
#include <utility>

namespace idiophone {

class ControlHint {
public:
    /// Call it regularly. Both components may be nullptr or lie outside the window. Returns an
    /// empty text if neither has a hint.
    juce::String find(const juce::Component& window,
                      juce::Component* underMouse,
                      juce::Component* focusedByKey) {
        if (std::exchange(lastUnderMouse, underMouse) != underMouse)
            keyCameLast = false;
        if (std::exchange(lastFocused, focusedByKey) != focusedByKey)
            keyCameLast = true;
        const auto mouse = tooltipAt(underMouse, window), key = tooltipAt(focusedByKey, window);
        return (keyCameLast && key.isNotEmpty()) || mouse.isEmpty() ? key : mouse;
    }

private:
    /// The tooltip of the component, or else of the nearest part around it, on one line.
    static juce::String tooltipAt(juce::Component* part, const juce::Component& window) {
        if (part == nullptr || !window.isParentOf(part) ||
            part->isCurrentlyBlockedByAnotherModalComponent())
            return {};
        for (; part != &window; part = part->getParentComponent()) {
            auto* client = dynamic_cast<juce::TooltipClient*>(part);
            if (client == nullptr)
                continue;
            if (const auto text = client->getTooltip(); text.isNotEmpty())
                return text.replace("\n", "; ");
        }
        return {};
    }

    const juce::Component *lastUnderMouse = nullptr, *lastFocused = nullptr; ///< only compared
    bool keyCameLast = false;
};

} // namespace idiophone
