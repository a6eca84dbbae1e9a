// Opens a parameter's menu over its control: on a right click, Shift+F10 or the menu key.
#pragma once

#include "Editor/ControlHost.h"
#include "Editor/ParameterMenu.h"

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <utility>

namespace idiophone {

/// A member of the control. Listens to it and to the parts in it, which ignore the right button.
class ControlMenu final : private juce::MouseListener, private juce::KeyListener {
public:
    ControlMenu(juce::Component& ofControl, const ParameterInfo& row, ProcessorView& processor)
        : control(ofControl), info(row), view(processor) {
        control.addMouseListener(this, true);
        control.addKeyListener(this);
    }
    ~ControlMenu() override {
        control.removeKeyListener(this);
        control.removeMouseListener(this);
    }

    /// Optional. Opens the text field of the value.
    std::function<void()> typeValue;

    /// The menu for the current state.
    juce::PopupMenu popup() const {
        const juce::Component::SafePointer<juce::Component> safe(&control);
        ParameterMenuActions actions;
        if (typeValue != nullptr)
            actions.typeValue = [safe, type = typeValue] {
                if (safe != nullptr)
                    type();
            };
        if (control.findParentComponentOfClass<ControlHost>() != nullptr)
            actions.listControllers = [safe] {
                if (safe != nullptr)
                    safe->findParentComponentOfClass<ControlHost>()->showControllers();
            };
        return parameterMenu(info, view, valueDisplayAround(control), std::move(actions));
    }

private:
    void show() {
        auto shown = popup();
        shown.setLookAndFeel(&control.getLookAndFeel());
        shown.showMenuAsync(
            juce::PopupMenu::Options().withTargetComponent(control).withDeletionCheck(control));
    }
    void mouseDown(const juce::MouseEvent& event) override {
        if (event.mods.isPopupMenu())
            show();
    }
    bool keyPressed(const juce::KeyPress& key, juce::Component*) override {
        if (!asksForMenu(key))
            return false;
        show();
        return true;
    }

    juce::Component& control;
    const ParameterInfo& info;
    ProcessorView& view;
};

} // namespace idiophone
