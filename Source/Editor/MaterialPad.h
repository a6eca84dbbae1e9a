// The map of materials: a dot for each named one, a ring at the current sound. A click on a dot
// selects that material; dragging elsewhere mixes live.
#pragma once

#include "Editor/DescribedComponent.h"
#include "Editor/GestureBurst.h"
#include "Editor/MaterialPlane.h"
#include "Editor/ProcessorView.h"

#include <optional>

namespace idiophone {

class MaterialPad final : public DescribedComponent {
public:
    explicit MaterialPad(ProcessorView& view);

    /// Moves the ring if the material has changed.
    void refresh();

    void paint(juce::Graphics& g) override;
    void mouseDown(const juce::MouseEvent& event) override;
    void mouseDrag(const juce::MouseEvent& event) override;
    void mouseUp(const juce::MouseEvent& event) override;
    void mouseMove(const juce::MouseEvent& event) override { hover(namedAt(event.position)); }
    void mouseExit(const juce::MouseEvent&) override { hover(std::nullopt); }
    bool keyPressed(const juce::KeyPress& key) override;
    void focusGained(FocusChangeType) override { repaint(); }
    void focusLost(FocusChangeType) override;
    juce::String description() const override;

private:
    juce::Rectangle<float> map() const;
    juce::Point<float> seenAt(const PlanePlace& place) const;
    PlanePlace placeAt(juce::Point<float> position) const;
    std::optional<std::size_t> namedAt(juce::Point<float> position) const;
    void choose(std::size_t named);
    void beginMix();
    void mix(const PlanePlace& place);
    void endMix();
    void paintNamed(juce::Graphics& g) const;
    void hover(std::optional<std::size_t> named);

    ProcessorView& view;
    PlanePlace shown{-1, -1};
    std::optional<std::size_t> hovered; ///< index into the material library
    bool mixing = false;
    GestureBurst burst; ///< joins presses of arrow keys into one gesture
};

} // namespace idiophone
