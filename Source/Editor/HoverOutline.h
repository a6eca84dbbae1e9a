// The outline of the object under the mouse, with its note and the velocity of a click there.
#pragma once

#include "Editor/ObjectScene.h"
#include "Editor/OrbitCamera.h"

#include <array>
#include <juce_gui_basics/juce_gui_basics.h>
#include <optional>
#include <utility>

namespace idiophone {

/// For the message thread.
class HoverOutline {
public:
    struct Hover {
        std::size_t object = 0;
        int note = -1; ///< MIDI note that a click plays; −1: the object has several keys
        int velocity = 0;
        std::optional<BodyNow> body{}; ///< on a stage

        bool operator==(const Hover&) const = default;
    };

    /// Returns whether the outline has changed. Show none before the scene changes.
    bool show(std::optional<Hover> next);
    const std::optional<Hover>& hover() const { return shown; }

    /// "C5, velocity 96".
    static juce::String textOf(const Hover& hover);

    /// Covers the component.
    void paint(juce::Graphics& g,
               const juce::Component& component,
               const ObjectScene& scene,
               const OrbitCamera& camera);

private:
    /// An outline is kept while these stay the same.
    struct View {
        std::size_t object = 0;
        std::optional<BodyNow> body;
        std::array<float, 16> viewProjection{};
        juce::Rectangle<float> area;

        bool operator==(const View&) const = default;
    };

    static juce::Path outlineOf(const ObjectScene& scene, const View& view);
    void paintText(juce::Graphics& g,
                   const juce::Component& component,
                   juce::Rectangle<float> around) const;

    std::optional<Hover> shown;
    std::optional<View> outlined; ///< the view of `outline`
    juce::Path outline;
};

} // namespace idiophone
