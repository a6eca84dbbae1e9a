// A list of a parameter's choices. The material's list also offers the user's materials.
#pragma once

#include "Editor/ParameterMenu.h"
#include "Editor/ProcessorView.h"
#include "Editor/Utf8.h"

#include <juce_gui_basics/juce_gui_basics.h>
#include <set>

namespace idiophone {

class ChoiceList final : public juce::ComboBox {
public:
    ChoiceList(const ParameterInfo& row, ProcessorView& processor) : info(row), view(processor) {
        setTitle(fromUtf8(info.name));
        if (info.parameter == ParameterId::material)
            view.materials.readUserMaterials();
        fill();
        onChange = [this] { choose(); };
        refresh();
    }

    void refresh() {
        if (info.parameter == ParameterId::material &&
            ownMaterials != view.materials.userMaterialNames())
            fill(); // another list has read the user's materials again
        showController();
        nameOwnMaterial();
        const int own =
            info.parameter == ParameterId::material ? view.materials.userMaterialIndex() : -1;
        const int item =
            own >= 0 ? firstUserItem + own
                     : firstChoiceItem + static_cast<int>(view.parameters.value(info.parameter));
        if (item != getSelectedId())
            setSelectedId(item, juce::dontSendNotification);
    }

    /// Reads the user's materials again before the list opens.
    void showPopup() override {
        if (info.parameter == ParameterId::material) {
            view.materials.readUserMaterials();
            refresh();
        }
        ComboBox::showPopup();
    }

private:
    // JUCE's item numbers start at 1.
    static constexpr int firstChoiceItem = 1, firstUserItem = 1000;

    /// "Own (Rosewood)", or "Own" if the objects have no common named material.
    static juce::String ownMaterialText(const ProcessorView& shown) {
        std::set<std::string> names;
        for (const auto& played : shown.instrument.playedObjects())
            names.insert(played.object->material.name);
        const juce::String own("Own");
        return names.size() != 1 || names.begin()->empty()
                   ? own
                   : own + " (" + fromUtf8(*names.begin()) + ")";
    }

    void fill() {
        clear(juce::dontSendNotification);
        int item = firstChoiceItem;
        for (const auto name : choiceNames(info.parameter))
            addItem(fromUtf8(name), item++);
        if (info.parameter != ParameterId::material)
            return;
        instrument = -1;
        ownMaterials = view.materials.userMaterialNames();
        if (!ownMaterials.empty())
            addSeparator();
        item = firstUserItem;
        for (const auto& name : ownMaterials)
            addItem(fromUtf8(name), item++);
    }
    void showController() {
        const auto sentence = controllerSentence(info, view.controllers);
        setTooltip(parameterTooltip(info, ValueDisplay::plain) +
                   (sentence.isEmpty() ? juce::String() : "\n" + sentence));
        setDescription(sentence);
    }
    void nameOwnMaterial() {
        if (info.parameter != ParameterId::material ||
            view.instrument.instrumentNumber() == instrument)
            return;
        instrument = view.instrument.instrumentNumber();
        changeItemText(firstChoiceItem, ownMaterialText(view));
        setSelectedId(0, juce::dontSendNotification); // else a selected item keeps its old text
    }
    void choose() {
        const int item = getSelectedId();
        if (item >= firstUserItem)
            return view.materials.chooseUserMaterial(item - firstUserItem);
        view.parameters.changeOnce(info.parameter, item - firstChoiceItem);
    }

    const ParameterInfo& info;
    ProcessorView& view;
    int instrument = -1;                   ///< the instrument whose material the first choice names
    std::vector<std::string> ownMaterials; ///< the user's materials in the list
};

} // namespace idiophone
