// The page of the objects' material: pad, named materials, figures, and a swap with the previous
// material.
#pragma once

#include "Editor/ChoiceList.h"
#include "Editor/DeckPage.h"
#include "Editor/MaterialPad.h"
#include "Editor/ParameterColumns.h"
#include "Editor/ParameterControl.h"

#include <array>
#include <memory>
#include <vector>

namespace idiophone {

class MaterialPage final : public DeckPage {
public:
    explicit MaterialPage(ProcessorView& view);

    void refresh() override;
    void resized() override;

    /// Swaps the current material with the one before the last change.
    void swapMaterials();

private:
    static constexpr std::array parameters{
        ParameterId::youngsModulus,       ParameterId::density,    ParameterId::fluidDamping,
        ParameterId::viscoelasticDamping, ParameterId::lossFactor, ParameterId::material};
    using Figures = std::array<double, parameters.size()>;

    Figures figuresNow() const;
    void watch();

    ProcessorView& view;
    MaterialPad pad;
    ChoiceList list;
    ParameterControl match, keep;
    juce::TextButton former{"A/B"};
    std::vector<std::unique_ptr<ParameterControl>> figures;
    Figures now, before;
    int instrument = -1;
    int ticksUnchanged = 0;
};

} // namespace idiophone
