// Finds the strikes of keys in the sound: slots that have become much louder.
#pragma once

#include "Editor/SoundView.h"

#include <map>
#include <span>
#include <utility>
#include <vector>

namespace idiophone {

/// For the message thread.
class StrikeWatch {
public:
    void reset() { known.clear(); }

    /// Takes the slots of the next frame. Returns those that were struck since the last one.
    std::vector<SlotNow> follow(std::span<const SlotNow> slots) {
        std::map<std::pair<int, int>, float> now;
        std::vector<SlotNow> struck;
        for (const auto& slot : slots) {
            const std::pair key{slot.object, slot.note};
            const auto before = known.find(key);
            if (slot.amplitude > faintest &&
                (before == known.end() || slot.amplitude > rise * before->second))
                struck.push_back(slot);
            now[key] = slot.amplitude;
        }
        known = std::move(now);
        return struck;
    }

private:
    static constexpr float rise = 1.3f;      ///< of the amplitude, more than a sum of modes beats
    static constexpr float faintest = 1e-5f; ///< m/s

    std::map<std::pair<int, int>, float> known; ///< amplitude by object and note
};

} // namespace idiophone
