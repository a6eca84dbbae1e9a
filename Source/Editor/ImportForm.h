// The import settings as a form: unit, material, thickness and method.
#pragma once

#include "Editor/Look.h"
#include "Editor/ProcessorView.h"

#include <array>
#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <optional>

namespace idiophone {

/// "2 mm".
juce::String thicknessText(double metres);
/// Parses a thickness in mm, cm, m or in; mm if there is no unit. Returns nothing unless it is a
/// number between 0.01 mm and 1 m.
std::optional<double> parseThicknessMetres(const juce::String& text);

/// Needs at least 340 x 92 px to show all text.
class ImportForm final : public juce::Component {
public:
    static constexpr int height = 92;

    explicit ImportForm(ProcessorView& view);

    /// Shows the settings, and the values that automatic settings chose.
    void show(const ImportStatus& status);

    void resized() override;

private:
    /// Reads the user's materials again whenever it opens.
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
    std::array<TextLabel, 4> names;
};

} // namespace idiophone
