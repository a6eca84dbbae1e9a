// How a key strikes: the mallet in the hand, its figures, and where it falls.
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
