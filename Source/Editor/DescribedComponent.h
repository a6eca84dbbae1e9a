// A painted component that a screen reader describes in a sentence.
#pragma once

#include <juce_gui_basics/juce_gui_basics.h>
#include <memory>

namespace idiophone {

class DescribedComponent : public juce::Component, public juce::SettableTooltipClient {
public:
    explicit DescribedComponent(juce::AccessibilityRole accessibleRole) : role(accessibleRole) {}

    /// The content, for the screen reader's read-only value.
    virtual juce::String description() const = 0;

    std::unique_ptr<juce::AccessibilityHandler> createAccessibilityHandler() override {
        return std::make_unique<juce::AccessibilityHandler>(
            *this, role, juce::AccessibilityActions{},
            juce::AccessibilityHandler::Interfaces{std::make_unique<Value>(*this)});
    }

protected:
    void notifyDescriptionChanged() {
        if (auto* handler = getAccessibilityHandler())
            handler->notifyAccessibilityEvent(juce::AccessibilityEvent::valueChanged);
    }

private:
    struct Value final : juce::AccessibilityTextValueInterface {
        explicit Value(const DescribedComponent& component) : described(component) {}
        bool isReadOnly() const override { return true; }
        juce::String getCurrentValueAsString() const override { return described.description(); }
        void setValueAsString(const juce::String&) override {}

        const DescribedComponent& described;
    };

    juce::AccessibilityRole role;
};

} // namespace idiophone
