// Keeps what the bodies of a stage did, to be taken along as MIDI or as a list of impulses.
#pragma once

#include "Instrument/Player.h"
#include "Object/Result.h"
#include "Plugin/OneWayQueue.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace idiophone {

class StageCapture {
public:
    /// Blows beyond are left out.
    static constexpr std::size_t mostBlows = 200'000;

    /// [audio thread] What a player's bodies did. Neither allocates, locks nor throws; what is not
    /// read in time is lost.
    void take(Player& player) noexcept;

    /// [message thread] Keeps what was taken; of another instrument or performance than before it
    /// begins anew.
    void follow(const std::shared_ptr<const Instrument>& instrument);
    void clear() { kept.clear(); }
    std::size_t count() const { return kept.size(); }

    /// [message thread] Both begin with the first blow. A blow on a bar is a note of its key, one
    /// on another object a note of the object's, from C2 (36) on; the hardest has velocity 127 and
    /// others fall with their impulse, as keys' blows do by the usual curve.
    Result<void> writeMidi(const std::filesystem::path& file, double beatsPerMinute) const;
    Result<void> writeImpulses(const std::filesystem::path& file) const;

private:
    std::vector<PlacedBlow> inOrder() const;

    struct Message {
        std::uint64_t instrument = 0; ///< its serial number
        std::uint32_t performance = 0;
        PlacedBlow blow;
    };

    OneWayQueue<Message, 1024> messages;
    std::shared_ptr<const Instrument> played;
    std::uint32_t performance = 0; ///< of what is kept
    std::vector<PlacedBlow> kept;
};

} // namespace idiophone
