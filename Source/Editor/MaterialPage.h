// What the objects are made of: the pad, the named materials, the figures, and the way back to the
// material before.
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

    /// Plays the material before the last change, which is then the one before.
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
