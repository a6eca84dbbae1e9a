#include "Instrument/KeyMap.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace idiophone {

double KeyMap::strikePlace(int midiNote) const {
    const int range = std::max(1, highestNote - lowestNote);
    const double share = std::clamp(static_cast<double>(midiNote - lowestNote) / range, 0.0, 1.0);
    if (kind == KeyMapKind::zones && highestNote > lowestNote)
        return share;
    const double place = share * static_cast<double>(strikeAt.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, strikeAt.size() - 1);
    return std::lerp(strikeAt[below], strikeAt[above], place - static_cast<double>(below));
}

std::string KeyMap::objectFor(int midiNote) const {
    constexpr std::string_view mark = "{note}";
    std::string name = object;
    if (const auto place = name.find(mark); kind == KeyMapKind::bars && place != std::string::npos)
        name.replace(place, mark.size(), std::to_string(midiNote));
    return name;
}

KitParts::KitParts(std::vector<KitPart> parts)
    : list(std::make_shared<const std::vector<KitPart>>(std::move(parts))) {}

const KitPart* KitParts::begin() const {
    return list ? list->data() : nullptr;
}

const KitPart* KitParts::end() const {
    return begin() + size();
}

std::size_t KitParts::size() const {
    return list ? list->size() : 0;
}

bool KitParts::operator==(const KitParts& other) const {
    return std::equal(begin(), end(), other.begin(), other.end());
}

KeyMap kitOf(std::vector<KitPart> parts) {
    KeyMap kit{.kind = KeyMapKind::kit, .lowestNote = 127, .highestNote = 0, .object = {}};
    for (const auto& part : parts) {
        kit.lowestNote = std::min(kit.lowestNote, part.keyMap.lowestNote);
        kit.highestNote = std::max(kit.highestNote, part.keyMap.highestNote);
    }
    kit.parts = KitParts(std::move(parts));
    return kit;
}

Result<void> validKit(const KeyMap& kit) {
    if (kit.parts.empty() || kit.parts.size() > maximumKitParts)
        return failure("are not 1 to " + std::to_string(maximumKitParts));
    std::array<std::array<int, 128>, 128> layers{}; // [note, velocity]
    for (const auto& part : kit.parts) {
        const auto& map = part.keyMap;
        if (map.kind == KeyMapKind::scene || map.kind == KeyMapKind::kit)
            return failure("have a scene or a kit among them");
        if (map.lowestNote < kit.lowestNote || map.highestNote > kit.highestNote)
            return failure("do not lie between the kit's notes");
        for (int note = map.lowestNote; note <= map.highestNote; ++note)
            for (int velocity = part.lowestVelocity; velocity <= part.highestVelocity; ++velocity)
                if (++layers.at(static_cast<std::size_t>(note))
                          .at(static_cast<std::size_t>(velocity)) > kitLayers)
                    return failure("are more than " + std::to_string(kitLayers) + " on key " +
                                   std::to_string(note) + " at velocity " +
                                   std::to_string(velocity));
    }
    return {};
}

std::vector<std::string> objectNames(const KeyMap& map) {
    std::vector<std::string> names;
    std::set<std::string> known;
    const auto add = [&](const KeyMap& one) {
        for (int note = one.lowestNote; note <= one.highestNote; ++note)
            if (auto name = one.objectFor(note); known.insert(name).second)
                names.push_back(std::move(name));
    };
    if (map.kind != KeyMapKind::kit)
        add(map);
    for (const auto& part : map.parts)
        add(part.keyMap);
    return names;
}

} // namespace idiophone
