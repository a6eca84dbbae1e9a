// How a mesh is made an object: unit, material, thickness and method, each a list or a figure.
#pragma once

#include "Editor/ProcessorView.h"

#include <array>
#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <optional>

namespace idiophone {

/// "2 mm".
juce::String thicknessText(double metres);
/// What a person typed, in mm, cm, m or in, and in mm where no unit is named; nothing for what is
/// no number or not between 0.01 mm and 1 m.
std::optional<double> parseThicknessMetres(const juce::String& text);

/// Text is whole from 340 x 92 px on.
class ImportForm final : public juce::Component {
public:
    static constexpr int height = 92;

    explicit ImportForm(ProcessorView& view);

    /// Shows these settings, and what automatic ones have come to.
    void show(const ImportStatus& status);

    void resized() override;

private:
    /// Looks for the user's materials anew whenever it opens.
    struct MaterialList final : juce::ComboBox {
        std::function<void()> beforeOpening;
        void showPopup() override {
            beforeOpening();
            ComboBox::showPopup();
        }
    };

    void describe(juce::Component& field,
                  juce::Label& name,
                  const juce::String& title,
                  const juce::String& tooltip);
    void fillMaterials();
    void typedThickness();
    void changeTo(const ImportSettings& wanted);

    ProcessorView& view;
    ImportSettings settings;
    juce::ComboBox unit, method;
    MaterialList material;
    juce::Label thickness;
    std::array<juce::Label, 4> names;
};

} // namespace idiophone
