// The list of a parameter's choices; for the material with the user's own behind them.
#pragma once

#include "Editor/ProcessorView.h"

#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

class ChoiceList final : public juce::ComboBox {
public:
    ChoiceList(const ParameterInfo& info, ProcessorView& view);

    /// Shows what the processor has.
    void refresh();

    /// The user's materials may have changed since it was open last.
    void showPopup() override;

private:
    void fill();
    void nameOwnMaterial();
    void choose();

    const ParameterInfo& info;
    ProcessorView& view;
    int instrument = -1;                   ///< whose material the first choice names
    std::vector<std::string> ownMaterials; ///< in the list
};

} // namespace idiophone
