// A list of a parameter's choices. The material's list also offers the user's materials.
#pragma once

#include "Editor/ProcessorView.h"

#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

class ChoiceList final : public juce::ComboBox {
public:
    ChoiceList(const ParameterInfo& info, ProcessorView& view);

    void refresh();

    /// Reads the user's materials again before the list opens.
    void showPopup() override;

private:
    void fill();
    void nameOwnMaterial();
    void choose();

    const ParameterInfo& info;
    ProcessorView& view;
    int instrument = -1;                   ///< the instrument whose material the first choice names
    std::vector<std::string> ownMaterials; ///< the user's materials in the list
};

} // namespace idiophone
