#include "Analysis/FactoryObjects.h"

#include "Analysis/FactoryBars.h"
#include "Analysis/FactoryProps.h"
#include "Analysis/FactoryShapes.h"

#include <algorithm>

namespace idiophone {

std::vector<std::string> factoryObjectNames() {
    std::vector<std::string> names;
    for (const auto& instrument : barInstruments())
        for (int note = instrument.lowestNote; note <= instrument.highestNote; ++note)
            names.push_back(instrument.barName(note));
    for (auto& name : factoryShapeNames())
        names.push_back(std::move(name));
    for (auto& name : factoryPropNames())
        names.push_back(std::move(name));
    return names;
}

Result<ModalObject> makeFactoryObject(const std::string& name, const WorkControl& control) {
    for (const auto& instrument : barInstruments())
        for (int note = instrument.lowestNote; note <= instrument.highestNote; ++note)
            if (instrument.barName(note) == name)
                return tuneBar(instrument.barAt(note, noteFrequencyHz(note)), control)
                    .map([](TunedBar tuned) { return std::move(tuned.object); });
    const auto props = factoryPropNames();
    return std::ranges::find(props, name) == props.end() ? makeFactoryShape(name, control)
                                                         : makeFactoryProp(name, control);
}

} // namespace idiophone
