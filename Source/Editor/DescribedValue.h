// Describes a component's content to a screen reader in a sentence.
#pragma once

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <memory>
#include <utility>

namespace idiophone {

/// For `createAccessibilityHandler`: a handler with a read-only value. It calls `sentence` only
/// while the component lives.
inline std::unique_ptr<juce::AccessibilityHandler>
describedValue(juce::Component& component,
               juce::AccessibilityRole role,
               std::function<juce::String()> sentence) {
    class Value final : public juce::AccessibilityTextValueInterface {
    public:
        explicit Value(std::function<juce::String()> shown) : words(std::move(shown)) {}
        bool isReadOnly() const override { return true; }
        juce::String getCurrentValueAsString() const override { return words(); }
        void setValueAsString(const juce::String&) override {}

    private:
        std::function<juce::String()> words;
    };
    return std::make_unique<juce::AccessibilityHandler>(
        component, role, juce::AccessibilityActions{},
        juce::AccessibilityHandler::Interfaces{std::make_unique<Value>(std::move(sentence))});
}

} // namespace idiophone
