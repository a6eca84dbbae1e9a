// Finds parts of a window by their accessible names, and counts their repaints.
#pragma once

#include <catch2/catch_test_macros.hpp>
#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone::test {

inline void visit(juce::Component& component, const std::function<void(juce::Component&)>& action) {
    action(component);
    for (auto* child : component.getChildren())
        visit(*child, action);
}

/// Returns the first component of that kind and title, or nullptr.
template <class Kind>
Kind* find(juce::Component& window, const juce::String& title) {
    Kind* found = nullptr;
    visit(window, [&](juce::Component& component) {
        if (auto* candidate = dynamic_cast<Kind*>(&component);
            found == nullptr && candidate != nullptr && component.getTitle() == title)
            found = candidate;
    });
    return found;
}

/// Returns the first component of that kind and title. Without one the test fails.
template <class Kind>
Kind& part(juce::Component& window, const juce::String& title) {
    auto* found = find<Kind>(window, title);
    INFO(title);
    REQUIRE(found != nullptr);
    return *found;
}

inline bool isOnScreen(const juce::Component& component, const juce::Component& window) {
    for (const auto* part = &component; part != &window; part = part->getParentComponent())
        if (!part->isVisible())
            return false;
    return true;
}

/// Counts the repaints of the component that owns it (Component::setCachedComponentImage).
struct RepaintCount final : juce::CachedComponentImage {
    explicit RepaintCount(int& counted) : repaints(counted) {}
    void paint(juce::Graphics&) override {}
    bool invalidateAll() override { return invalidate({}); }
    bool invalidate(const juce::Rectangle<int>&) override {
        ++repaints;
        return false;
    }
    void releaseResources() override {}

    int& repaints;
};

} // namespace idiophone::test
