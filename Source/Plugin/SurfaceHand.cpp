#include "Plugin/SurfaceHand.h"

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

void SurfaceHand::strike(const std::shared_ptr<const Instrument>& instrument,
                         std::size_t slot,
                         const std::array<double, 3>& pointMetres,
                         int velocity) {
    const auto& object = instrument->slots()[slot].object;
    if (!surface || surface->object != object)
        surface.emplace(object);
    blows.push({.instrument = instrument.get(),
                .strike = {.slot = slot,
                           .point = surface->places.nearest(pointMetres),
                           .velocity = velocity}});
}

void SurfaceHand::strikeOn(Player* player) noexcept {
    blows.read([player](const Blow& blow) {
        if (player != nullptr && &player->instrument() == blow.instrument)
            player->strikeSurface(blow.strike);
    });
}

} // namespace idiophone
