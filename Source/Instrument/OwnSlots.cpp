#include "Instrument/OwnSlots.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace idiophone {

std::vector<std::size_t> ownSlots(const Instrument& instrument) {
    const auto slots = instrument.slots();
    const auto octavesOff = [&](std::size_t slot) {
        return std::abs(std::log2(slots[slot].sizeRatio));
    };
    std::map<const ModalObject*, std::size_t> nearest;
    for (std::size_t slot = 0; slot < slots.size(); ++slot) {
        const auto [found, isNew] = nearest.try_emplace(slots[slot].object.get(), slot);
        if (!isNew && octavesOff(slot) < octavesOff(found->second))
            found->second = slot;
    }
    std::vector<std::size_t> result;
    for (std::size_t slot = 0; slot < slots.size(); ++slot)
        if (nearest.at(slots[slot].object.get()) == slot)
            result.push_back(slot);
    return result;
}

std::vector<int> objectsOfSlots(const Instrument& instrument) {
    const auto slots = instrument.slots();
    const auto own = ownSlots(instrument);
    std::map<const ModalObject*, int> places;
    for (std::size_t object = 0; object < own.size(); ++object)
        places.emplace(slots[own[object]].object.get(), static_cast<int>(object));
    std::vector<int> result;
    for (const auto& slot : slots)
        result.push_back(places.at(slot.object.get()));
    return result;
}

} // namespace idiophone
