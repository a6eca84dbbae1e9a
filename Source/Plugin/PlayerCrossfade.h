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

    /// [message side] while no callback runs: plays this one from its start, at once.
    void install(std::unique_ptr<Player> player);

    /// Plays `next`, which it now owns, with `values` from here on, pedal and controllers where
    /// they are; what rang before fades out under it. A second change within a fade cuts the player
    /// that has hardly begun, and lets the older one fade on. nullptr changes nothing.
    void changeTo(Player* next, const ParameterValues& values) noexcept;

    /// The next samples, at most `BlockPieces::maximumSamples`; see `Player::process`.
    void process(const StereoSpan& output,
                 std::span<const MidiEvent> events,
                 const ParameterValues& values) noexcept;

    /// Silence, at once.
    void reset() noexcept;

    Player* player() const noexcept { return current; }

private:
    void followControllers(std::span<const MidiEvent> events) noexcept;
    void addFading(const StereoSpan& output) noexcept;

    Handoff<Player>& handoff;
    Player* current = nullptr;
    Player* fading = nullptr;
    int fadePosition = 0;
    ParameterValues lastValues;
    ParameterValues fadingValues; ///< what held before the change, so that the fade keeps its sound
    std::array<float, BlockPieces::maximumSamples> fadingLeft{}, fadingRight{};

    // The pedal and the wheel are the same for all channels, speed and place each channel's own.
    static constexpr std::size_t shared = 2;
    static constexpr auto atRest = [] {
        std::array<MidiEvent, shared + 2 * 16> events{};
        events[0].bytes = {0xb0, 64, 0};
        events[1].bytes = {0xe0, 0, 64};
        for (std::size_t channel = 0; channel < 16; ++channel) {
            const auto status = static_cast<std::uint8_t>(0xb0 | channel);
            events[shared + 2 * channel].bytes = {status, 1, 64};
            events[shared + 2 * channel + 1].bytes = {status, 74, 64};
        }
        return events;
    }();
    std::array<MidiEvent, atRest.size()> controllers = atRest;
};

} // namespace idiophone
