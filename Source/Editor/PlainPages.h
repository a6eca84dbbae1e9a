// Adds the pages between tuning and import, which only hold parameters.
#pragma once

#include "Editor/LfoPage.h"
#include "Editor/ModulationPage.h"
#include "Editor/PageDeck.h"
#include "Editor/ParameterPage.h"

#include <memory>
#include <vector>

namespace idiophone {

inline void addPlainPages(PageDeck& deck, ProcessorView& view) {
    using Groups = std::vector<ParameterGroup>;
    deck.add(std::make_unique<ParameterPage>(
        "Contact", Groups{{"Scrape, roll, bow", 0}, {"Keys", 1}, {"Motor", 1}}, view));
    deck.add(std::make_unique<ParameterPage>(
        "Output", Groups{{"Listening", 0}, {"Room", 0}, {"Output", 1}, {"Sound in", 1}}, view));
    deck.add(std::make_unique<LfoPage>(view)); // beside the next one
    deck.add(std::make_unique<ModulationPage>(view));
}

} // namespace idiophone
