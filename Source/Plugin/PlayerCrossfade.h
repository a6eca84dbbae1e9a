// What the audio thread plays: the current player, and the one before it for the few milliseconds
// in which it fades out.
#pragma once

#include "Instrument/Player.h"
#include "Plugin/BlockPieces.h"
#include "Plugin/Handoff.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace idiophone {

/// Owns its players and gives them back through the handoff. Everything but the constructor, the
/// destructor and `install` is for the audio thread and neither allocates, locks nor throws.
class PlayerCrossfade {
public:
    static constexpr double fadeSeconds = 0.005; // by ear: short, and no click

    explicit PlayerCrossfade(Handoff<Player>& retireThrough) : handoff(retireThrough) {}
    PlayerCrossfade(const PlayerCrossfade&) = delete;
    PlayerCrossfade& operator=(const PlayerCrossfade&) = delete;
    ~PlayerCrossfade(); ///< [message side] after the last callback

    /// [message side] while no callback runs: plays this one from its start, at once, with
    /// controllers at rest but MPE's zones and bend ranges as MIDI has set them.
    void install(std::unique_ptr<Player> player);

    /// Plays `next`, which it now owns, from here on, pedals and controllers where they are; what
    /// rang before fades out under it. A second change within a fade cuts the player that has
    /// hardly begun, and lets the older one fade on. Whatever fades is heard through the output of
    /// what plays, and is multiplied by `levelBefore`, the old level to the new one. nullptr
    /// changes nothing.
    void changeTo(Player* next, float levelBefore = 1) noexcept;

    /// The next samples, at most `BlockPieces::maximumSamples`; see `Player::process`.
    void process(const StereoSpan& output,
                 std::span<const MidiEvent> events,
                 const ParameterValues& values) noexcept;

    /// Silence, at once.
    void reset() noexcept;

    Player* player() const noexcept { return current; }

private:
    void addFading(const StereoSpan& output) noexcept;

    Handoff<Player>& handoff;
    Player* current = nullptr;
    Player* fading = nullptr;
    int fadePosition = 0;
    float fadingLevel = 1; ///< to that of what plays
    ParameterValues lastValues;
    ParameterValues fadingValues; ///< what held before the change, so that the fade keeps its sound
    std::array<float, BlockPieces::maximumSamples> fadingLeft{}, fadingRight{};
};

} // namespace idiophone
