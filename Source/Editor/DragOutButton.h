// A button from which a file can be dragged into the host or a folder; a click does not drag.
#pragma once

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <utility>

namespace idiophone {

/// `Kind` is the kind of button.
template <class Kind>
class DragOutButton : public Kind {
public:
    using Kind::Kind;

    /// Returns the file to drag, or an empty File if there is none. Called when a drag starts.
    std::function<juce::File()> fileToDrag;

    void mouseDown(const juce::MouseEvent& event) override {
        isDragged = false;
        Kind::mouseDown(event);
    }
    void mouseDrag(const juce::MouseEvent& event) override {
        constexpr int pixelsToDrag = 6;
        if (isDragged || event.getDistanceFromDragStart() < pixelsToDrag)
            return Kind::mouseDrag(event);
        isDragged = true;
        if (const auto file = fileToDrag(); file != juce::File())
            juce::DragAndDropContainer::performExternalDragDropOfFiles({file.getFullPathName()},
                                                                       false, this);
    }
    void mouseUp(const juce::MouseEvent& event) override {
        if (isDragged)
            this->setState(juce::Button::buttonNormal); // a drag does not click
        else
            Kind::mouseUp(event);
    }

private:
    bool isDragged = false;
};

} // namespace idiophone
