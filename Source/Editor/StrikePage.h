// The page of the strike: the mallet, its figures, and the strike place.
#pragma once

#include "Editor/DeckPage.h"
#include "Editor/MalletRack.h"
#include "Editor/ParameterColumns.h"

namespace idiophone {

class StrikePage final : public DeckPage {
public:
    explicit StrikePage(ProcessorView& view);

    void refresh() override;
    void resized() override;

private:
    MalletRack rack;
    ParameterColumns columns;
};

} // namespace idiophone
