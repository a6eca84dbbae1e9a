// The import settings as a form: unit, material, size, thickness, method, and how it is held.
#pragma once

#include "Editor/HeldList.h"
#include "Editor/ImportMeasures.h"
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

/// Needs at least 340 x 92 px to show all text.
class ImportForm final : public juce::Component {
public:
    static constexpr int height = 92;

    explicit ImportForm(ProcessorView& processor) : view(processor) {
        describe(unit, "Unit", "Unit", "The unit of length of the mesh file");
        describe(material, "Material", "Material", "The material of the object");
        describe(held, "Held", "Held",
                 "Where the object is held still while it sounds. For a painted region, drag over "
                 "the object in the picture.");
        describe(size, "Longest side", "Longest side",
                 "Type a length, in cm or with a unit, to scale the object");
        describe(thickness, "Thickness", "Thickness of shells",
                 "Wall thickness if the mesh is a shell, in mm or with a unit");
        describe(method, "Method", "Method",
                 "What the mesh is: a solid body, or a shell if it is thin or open");
        describe(support, "Support", "Support",
                 "What holds the object: the softer, the more of its vibration it takes");
        fill(unit, units);
        fill(support, supports);
        fill(method, methods);
        fillMaterials();
        material.beforeOpening = [this] { fillMaterials(); };
        size.setEditable(true);
        thickness.setEditable(true);
        for (auto* list : {&unit, &method, &support})
            list->onChange = [this] { takeChoices(); };
        held.onChange = material.onChange = [this] { takeChoices(); };
        size.onTextChange = [this] {
            typed(size, &ImportSettings::longestMetres, parseSizeMetres(size.getText()));
        };
        thickness.onTextChange = [this] {
            typed(thickness, &ImportSettings::thicknessMetres,
                  parseThicknessMetres(thickness.getText()));
        };
        show(view.workshop.importStatus());
    }

    /// Shows the settings, and the values that automatic settings chose.
    void show(const ImportStatus& status) {
        settings = status.settings;
        select(unit, units, settings.unit, fromUtf8(status.unit));
        const auto* taken = find(methods, status.method);
        select(method, methods, settings.method,
               taken == nullptr || status.method.empty() ? "" : taken->name);
        if (material.getText() != fromUtf8(settings.material))
            material.setText(fromUtf8(settings.material), juce::dontSendNotification);
        held.show(status);
        support.setEnabled(settings.held.kind != HeldSettings::Kind::free);
        const auto known =
            std::ranges::find(supports, settings.held.quality, &SupportChoice::quality);
        const int item = static_cast<int>(known - supports.begin()) + 1; // none: no such item
        if (support.getSelectedId() != item)
            support.setSelectedId(item, juce::dontSendNotification);
        longestMetres = *std::ranges::max_element(status.sidesMetres);
        for (auto* field : {&size, &thickness}) {
            if (!field->isBeingEdited())
                showLength(*field);
            field->setColour(juce::Label::outlineColourId, colourOf(*this, LookColour::outline));
        }
    }

    void resized() override {
        constexpr int gap = 8, nameHeight = 17, rowGap = 6;
        const int third = (getWidth() - 2 * gap) / 3, fields = getWidth() - 3 * gap;
        auto area = getLocalBounds();
        auto upper = area.removeFromTop((getHeight() - rowGap) / 2);
        area.removeFromTop(rowGap);
        std::size_t next = 0;
        const auto place = [&](juce::Component& field, juce::Rectangle<int>& row, int width) {
            auto cell = row.removeFromLeft(width);
            row.removeFromLeft(gap);
            names[next++].setBounds(cell.removeFromTop(nameHeight));
            field.setBounds(cell);
        };
        place(unit, upper, third);
        place(material, upper, third);
        place(held, upper, third);
        place(size, area, fields / 4);
        place(thickness, area, fields / 5);
        place(method, area, (area.getWidth() - gap) / 2);
        place(support, area, area.getWidth());
    }

private:
    struct Choice {
        const char* id; ///< value in ImportSettings
        const char* name;
    };

    struct SupportChoice {
        double quality; ///< value in HeldSettings
        const char* name;
    };

    // A mode of 400 Hz sounds for 5, 1 and 0.2 s in the latter three.
    static constexpr std::array supports{SupportChoice{0, "Rigid"}, SupportChoice{1000, "Metal"},
                                         SupportChoice{200, "Wood"}, SupportChoice{40, "Soft"}};
    static constexpr std::array units{Choice{"", "Auto"},          Choice{"m", "Metres"},
                                      Choice{"cm", "Centimetres"}, Choice{"mm", "Millimetres"},
                                      Choice{"in", "Inches"},      Choice{"ft", "Feet"}};
    static constexpr std::array methods{Choice{"", "Auto"}, Choice{"fem", "Solid"},
                                        Choice{"two-layer", "Shell"},
                                        Choice{"spring-mass", "Shell of springs, as published"},
                                        Choice{"van-gelder", "Shell of van Gelder's springs"}};

    static void fill(juce::ComboBox& list, const auto& choices) {
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

    /// Selects the choice `id`. `taken` names what the automatic first choice led to, or is empty.
    static void select(juce::ComboBox& list,
                       std::span<const Choice> choices,
                       const std::string& id,
                       const juce::String& taken) {
        juce::String text(choices[0].name);
        if (taken.isNotEmpty())
            text << ": " << taken;
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

    /// Describes the next field; `words` stand above it.
    void describe(juce::Component& field,
                  const juce::String& words,
                  const juce::String& title,
                  const juce::String& tooltip) {
        auto& name = names[described++];
        field.setTitle(title);
        if (auto* client = dynamic_cast<juce::SettableTooltipClient*>(&field))
            client->setTooltip(tooltip);
        name.setText(words, juce::dontSendNotification);
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
    /// Takes what is selected in the lists.
    void takeChoices() {
        auto wanted = settings;
        wanted.unit = chosen(unit, units);
        if (wanted.unit != settings.unit)
            wanted.longestMetres = 0; // the unit says the size now
        wanted.method = chosen(method, methods);
        wanted.material = material.getText().toStdString();
        wanted.held = held.chosen(settings.held);
        if (const auto item = static_cast<std::size_t>(support.getSelectedItemIndex());
            item < supports.size())
            wanted.held.quality = supports[item].quality;
        changeTo(wanted);
    }
    /// Takes a typed length, or shows the former one again.
    void
    typed(juce::Label& field, double ImportSettings::*length, const std::optional<double>& metres) {
        auto wanted = settings;
        if (metres)
            wanted.*length = *metres;
        changeTo(wanted);
        showLength(field);
    }
    void showLength(juce::Label& field) {
        const double longest = settings.longestMetres > 0 ? settings.longestMetres : longestMetres;
        field.setText(&field == &thickness ? thicknessText(settings.thicknessMetres)
                      : longest > 0        ? sizeText(longest)
                                           : juce::String(),
                      juce::dontSendNotification);
    }
    void changeTo(const ImportSettings& wanted) {
        if (wanted == settings)
            return;
        settings = wanted;
        view.workshop.setImportSettings(settings);
    }

    ProcessorView& view;
    ImportSettings settings;
    juce::ComboBox unit, method, support;
    HeldList held;
    MaterialList material;
    juce::Label size, thickness;
    double longestMetres = 0; ///< of the object, or 0
    std::array<TextLabel, 7> names;
    std::size_t described = 0; ///< number of fields with a name
};

} // namespace idiophone
