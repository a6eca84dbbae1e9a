// Records the impacts of a stage's bodies, for export as MIDI or as a list of impulses.
#pragma once

#include "Instrument/Player.h"
#include "Object/Result.h"

#include <boost/lockfree/spsc_queue.hpp>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace idiophone {

class StageCapture {
public:
    /// Further impacts are not recorded.
    static constexpr std::size_t maximumImpacts = 200'000;

    /// [audio thread] Queues the impacts of a player's bodies. Neither allocates, locks nor throws.
    /// Impacts not read in time are lost.
    void take(Player& player) noexcept;

    /// [message thread] Stores the queued impacts. Starts again if the instrument changes, or if
    /// the stage was stopped or reset.
    void follow(const std::shared_ptr<const Instrument>& instrument);
    void clear() { kept.clear(); }
    std::size_t count() const { return kept.size(); }

    /// [message thread] Both files start at the first impact. An impact on a bar becomes a note of
    /// its key. Other objects get notes from C2 (36) on. The hardest impact has velocity 127; the
    /// others follow their impulse by the keys' default velocity curve.
    Result<void> writeMidi(const std::filesystem::path& file, double beatsPerMinute) const;
    Result<void> writeImpulses(const std::filesystem::path& file) const;

private:
    std::vector<PlacedImpact> inOrder() const;

    struct Message {
        std::uint64_t instrument = 0; ///< its serial number
        std::uint32_t performance = 0;
        PlacedImpact impact;
    };

    boost::lockfree::spsc_queue<Message, boost::lockfree::capacity<1024>> messages;
    std::shared_ptr<const Instrument> played;
    std::uint32_t performance = 0; ///< StagePlayer::number of `kept`
    std::vector<PlacedImpact> kept;
};

} // namespace idiophone
