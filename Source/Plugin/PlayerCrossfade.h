// Plays the current player, and the previous one during its fade-out of a few milliseconds.
#pragma once

#include "Instrument/Player.h"
#include "Plugin/Handoff.h"
#include "Plugin/OutputMemory.h"

#include <memory>
#include <span>

namespace idiophone {

/// Owns its players and gives them back through the handoff. Except the constructor, the destructor
/// and `install`, all functions are for the audio thread and neither allocate, lock nor throw.
class PlayerCrossfade {
public:
    static constexpr double fadeSeconds = 0.005; // by ear: short, and no click

    explicit PlayerCrossfade(Handoff<Player>& retireThrough) : handoff(retireThrough) {}
    PlayerCrossfade(const PlayerCrossfade&) = delete;
    PlayerCrossfade& operator=(const PlayerCrossfade&) = delete;
    ~PlayerCrossfade(); ///< [message side] Call after the last callback.

    /// [message side] Call while no callback runs. Plays this player from its start, at once.
    /// Controllers are at rest, but zones and bend ranges that MIDI has set are kept.
    void install(std::unique_ptr<Player> player);

    /// Plays `next`, now owned, with pedals and controllers where they are; the old player fades
    /// out under it at the values `former`. A second change within a fade cuts the player that has
    /// just begun and lets the older one finish its fade. The fading player goes through the
    /// current output level; `levelBefore`, the old level divided by the new one, compensates for
    /// that level. Ignores nullptr.
    void changeTo(Player* next, const ParameterValues& former, float levelBefore = 1) noexcept;

    /// Renders the next samples, at most `BlockPieces::maximumSamples`; see `Player::process`. The
    /// input presses on the current player's objects only.
    void process(std::span<const StereoSpan> outputs,
                 std::span<const MidiEvent> events,
                 const ParameterValues& values,
                 std::span<const float> input = {}) noexcept;
    /// Renders the main output only.
    void process(const StereoSpan& output,
                 std::span<const MidiEvent> events,
                 const ParameterValues& values,
                 std::span<const float> input = {}) noexcept {
        process(std::span(&output, 1), events, values, input);
    }

    /// Silences everything at once.
    void reset() noexcept;

    Player* player() const noexcept { return current; }

private:
    void addFading(std::span<const StereoSpan> outputs) noexcept;

    Handoff<Player>& handoff;
    Player* current = nullptr;
    Player* fading = nullptr;
    int fadePosition = 0;
    float fadingLevel = 1;        ///< relative to the current player's level
    ParameterValues fadingValues; ///< from before the change, to keep the fading sound
    OutputMemory fadingMemory;
};

} // namespace idiophone
