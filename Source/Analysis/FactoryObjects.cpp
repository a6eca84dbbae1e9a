#include "Analysis/FactoryObjects.h"

#include "Analysis/FactoryBars.h"
#include "Analysis/FactoryShapes.h"

namespace idiophone {

std::vector<std::string> factoryObjectNames() {
    std::vector<std::string> names;
    for (const auto& instrument : barInstruments())
        for (int note = instrument.lowestNote; note <= instrument.highestNote; ++note)
            names.push_back(instrument.barName(note));
    for (auto& name : factoryShapeNames())
        names.push_back(std::move(name));
    return names;
}

Result<ModalObject> makeFactoryObject(const std::string& name, const WorkControl& control) {
    for (const auto& instrument : barInstruments())
        for (int note = instrument.lowestNote; note <= instrument.highestNote; ++note)
            if (instrument.barName(note) == name)
                return tuneBar(instrument.barAt(note, noteFrequencyHz(note)), control)
                    .map([](TunedBar tuned) { return std::move(tuned.object); });
    return makeFactoryShape(name, control);
}

} // namespace idiophone
