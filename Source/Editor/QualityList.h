// The list of qualities: each one sets the four parameters of quality together.
#pragma once

#include "Editor/NamedEdit.h"
#include "Editor/ProcessorView.h"

#include <algorithm>
#include <array>
#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

/// Shows "Own" while the parameters equal none of the qualities.
class QualityList final : public juce::ComboBox {
public:
    explicit QualityList(ProcessorView& processor) : view(processor) {
        setTitle("Quality");
        setTooltip("Eco costs less processor time, High computes more faint modes; Own stands for "
                   "values that you set below");
        for (std::size_t i = 0; i < qualities.size(); ++i)
            addItem(qualities[i].name, static_cast<int>(i) + 1);
        addItem("Own", ownItem);
        setItemEnabled(ownItem, false);
        onChange = [this] { choose(); };
        refresh();
    }

    void refresh() {
        const auto found = std::ranges::find_if(
            qualities, [this](const Quality& quality) { return isChosen(quality); });
        const int item = found == qualities.end()
                             ? ownItem
                             : static_cast<int>(std::distance(qualities.begin(), found)) + 1;
        if (item != getSelectedId())
            setSelectedId(item, juce::dontSendNotification);
    }

private:
    static constexpr std::array parameters{ParameterId::tau, ParameterId::compression,
                                           ParameterId::modeBudget, ParameterId::qualitySlope};
    struct Quality {
        const char* name;
        std::array<double, parameters.size()> values; ///< in the order of `parameters`
    };
    // Normal has the defaults of the table. The manual has the measured costs of the others.
    static constexpr std::array qualities{Quality{"Eco", {4, 2, 1024, 1}},
                                          Quality{"Normal", {0.1, 1, 4096, 1}},
                                          Quality{"High", {0.02, 0.5, 16384, 1}}};
    static constexpr int ownItem = static_cast<int>(qualities.size()) + 1;

    bool isChosen(const Quality& quality) const {
        return std::ranges::equal(parameters, quality.values,
                                  [this](ParameterId parameter, double value) {
                                      return view.parameters.value(parameter) == value;
                                  });
    }
    void choose() {
        const auto index = static_cast<std::size_t>(getSelectedId() - 1);
        if (index >= qualities.size())
            return refresh();
        const NamedEdit step(view.history, "Quality");
        for (std::size_t i = 0; i < parameters.size(); ++i)
            view.parameters.changeOnce(parameters[i], qualities[index].values[i]);
    }

    ProcessorView& view;
};

} // namespace idiophone
