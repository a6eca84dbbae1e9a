// The import settings as a form: unit, material, thickness and method.
#pragma once

#include "Editor/Look.h"
#include "Editor/ProcessorView.h"
#include "Editor/Utf8.h"

#include <algorithm>
#include <array>
#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace idiophone {

/// "2 mm".
inline juce::String thicknessText(double metres) {
    return juce::String(juce::String(1000 * metres, 3).getDoubleValue()) + " mm";
}
/// Parses a thickness in mm, cm, m or in; mm if there is no unit. Returns nothing unless it is a
/// number between 0.01 mm and 1 m.
inline std::optional<double> parseThicknessMetres(const juce::String& text) {
    const auto plain = text.trim().toLowerCase().replaceCharacter(',', '.');
    const auto number = plain.initialSectionContainingOnly("0123456789.");
    const auto word = plain.substring(number.length()).trim();
    double metresPerUnit = 1e-3;
    if (word == "m")
        metresPerUnit = 1;
    else if (word == "cm")
        metresPerUnit = 1e-2;
    else if (word == "in" || word == "\"")
        metresPerUnit = 0.0254;
    else if (word.isNotEmpty() && word != "mm")
        return std::nullopt;
    const double metres = number.getDoubleValue() * metresPerUnit;
    if (!number.containsAnyOf("0123456789") || !(metres >= 1e-5 && metres <= 1))
        return std::nullopt;
    return metres;
}

/// Needs at least 340 x 92 px to show all text.
class ImportForm final : public juce::Component {
public:
    static constexpr int height = 92;

    explicit ImportForm(ProcessorView& processor) : view(processor) {
        describe(unit, names[0], "Unit", "The unit of length of the mesh file");
        describe(material, names[1], "Material", "The material of the object");
        describe(thickness, names[2], "Thickness of shells",
                 "Wall thickness if the mesh is a shell, in mm or with a unit");
        describe(
            method, names[3], "Method",
            "How the mesh is analysed: solids by finite elements, thin or open meshes as shells");
        fill(unit, units);
        fill(method, methods);
        fillMaterials();
        material.beforeOpening = [this] { fillMaterials(); };
        thickness.setEditable(true);
        unit.onChange = method.onChange = material.onChange = [this] {
            auto wanted = settings;
            wanted.unit = chosen(unit, units);
            wanted.method = chosen(method, methods);
            wanted.material = material.getText().toStdString();
            changeTo(wanted);
        };
        thickness.onTextChange = [this] { typedThickness(); };
        show(view.workshop.importStatus());
    }

    /// Shows the settings, and the values that automatic settings chose.
    void show(const ImportStatus& status) {
        settings = status.settings;
        select(unit, units, settings.unit, status.unit);
        select(method, methods, settings.method, status.method);
        if (material.getText() != fromUtf8(settings.material))
            material.setText(fromUtf8(settings.material), juce::dontSendNotification);
        if (!thickness.isBeingEdited())
            thickness.setText(thicknessText(settings.thicknessMetres), juce::dontSendNotification);
        thickness.setColour(juce::Label::outlineColourId, colourOf(*this, LookColour::outline));
    }

    void resized() override {
        constexpr int gap = 12, nameHeight = 17, rowGap = 6;
        const std::array<juce::Component*, 4> fields{&unit, &material, &thickness, &method};
        const int width = (getWidth() - gap) / 2;
        const int row = (getHeight() - rowGap) / 2;
        for (int i = 0; i < 4; ++i) {
            juce::Rectangle<int> area((i % 2) * (width + gap), (i / 2) * (row + rowGap), width,
                                      row);
            names[static_cast<std::size_t>(i)].setBounds(area.removeFromTop(nameHeight));
            fields[static_cast<std::size_t>(i)]->setBounds(area);
        }
    }

private:
    struct Choice {
        const char* id; ///< value in ImportSettings
        const char* name;
    };

    static constexpr std::array units{Choice{"", "Guessed"},       Choice{"m", "Metres"},
                                      Choice{"cm", "Centimetres"}, Choice{"mm", "Millimetres"},
                                      Choice{"in", "Inches"},      Choice{"ft", "Feet"}};
    static constexpr std::array methods{Choice{"", "Auto"}, Choice{"fem", "Finite elements"},
                                        Choice{"two-layer", "Shell, two layers"},
                                        Choice{"spring-mass", "Shell, springs as published"},
                                        Choice{"van-gelder", "Shell, van Gelder's springs"}};

    static void fill(juce::ComboBox& list, std::span<const Choice> choices) {
        int item = 1;
        for (const auto& choice : choices)
            list.addItem(choice.name, item++);
    }

    static std::string chosen(const juce::ComboBox& list, std::span<const Choice> choices) {
        return choices[static_cast<std::size_t>(std::max(list.getSelectedItemIndex(), 0))].id;
    }

    static const Choice* find(std::span<const Choice> choices, const std::string& id) {
        const auto found =
            std::ranges::find_if(choices, [&](const Choice& choice) { return id == choice.id; });
        return found == choices.end() ? nullptr : &*found;
    }

    /// Selects the choice `id`. `taken` is the value that the automatic first choice led to, or
    /// empty.
    static void select(juce::ComboBox& list,
                       std::span<const Choice> choices,
                       const std::string& id,
                       const std::string& taken) {
        juce::String text(choices[0].name);
        if (const auto* automatic = find(choices, taken); automatic != nullptr && !taken.empty())
            text << ": " << automatic->name;
        if (list.getItemText(0) != text) {
            list.changeItemText(1, text);
            if (list.getSelectedId() == 1)
                list.setText(text, juce::dontSendNotification);
        }
        const auto* wanted = find(choices, id);
        const int item = wanted == nullptr ? 1 : static_cast<int>(wanted - choices.data()) + 1;
        if (list.getSelectedId() != item)
            list.setSelectedId(item, juce::dontSendNotification);
    }

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
                  const juce::String& tooltip) {
        field.setTitle(title);
        if (auto* client = dynamic_cast<juce::SettableTooltipClient*>(&field))
            client->setTooltip(tooltip);
        name.setText(title, juce::dontSendNotification);
        name.setAccessible(false);
        name.setInterceptsMouseClicks(false, false);
        showParts(*this, name, field);
    }
    void fillMaterials() {
        material.clear(juce::dontSendNotification);
        int item = 1;
        const auto library = choiceNames(ParameterId::material);
        for (const auto name : library.subspan(firstLibraryMaterial))
            material.addItem(fromUtf8(name), item++);
        const auto own = view.materials.readUserMaterials();
        if (!own.empty())
            material.addSeparator();
        for (const auto& name : own)
            material.addItem(fromUtf8(name), item++);
        material.setText(fromUtf8(settings.material), juce::dontSendNotification);
    }
    void typedThickness() {
        auto wanted = settings;
        if (const auto metres = parseThicknessMetres(thickness.getText()))
            wanted.thicknessMetres = *metres;
        thickness.setText(thicknessText(wanted.thicknessMetres), juce::dontSendNotification);
        changeTo(wanted);
    }
    void changeTo(const ImportSettings& wanted) {
        if (wanted == settings)
            return;
        settings = wanted;
        view.workshop.setImportSettings(settings);
    }

    ProcessorView& view;
    ImportSettings settings;
    juce::ComboBox unit, method;
    MaterialList material;
    juce::Label thickness;
    std::array<TextLabel, 4> names;
};

} // namespace idiophone
