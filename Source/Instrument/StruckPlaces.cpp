#include "Instrument/StruckPlaces.h"

#include "Instrument/StrikePointMetres.h"

#include <algorithm>

namespace idiophone {

std::vector<std::array<double, 3>> struckPlaces(const Instrument& instrument, std::size_t slot) {
    std::vector<std::array<double, 3>> places;
    const auto& object = *instrument.slots()[slot].object;
    for (int note = 0; note < 128; ++note) {
        const auto keys = instrument.keysOf(note);
        const auto found = std::ranges::find(keys, static_cast<int>(slot), &Key::slot);
        if (found == keys.end())
            continue;
        const auto& strip = *found->strip;
        for (int along = 0; along < strip.alongCount; ++along)
            places.push_back(strikePointMetres(
                object,
                strip.at(static_cast<double>(along) / std::max(strip.alongCount - 1, 1), 0)));
        break; // the keys of one object share its path
    }
    return places;
}

} // namespace idiophone
