// Turns MIDI into sound, callback by callback. It owns everything of the audio thread and knows
// neither the host nor the session, only their messages.
#pragma once

#include "Output/OutputStage.h"
#include "Plugin/BlockPieces.h"
#include "Plugin/EngineMessages.h"
#include "Plugin/EngineReport.h"
#include "Plugin/HostTransport.h"
#include "Plugin/PlayerCrossfade.h"
#include "Plugin/ProgramChanges.h"

#include <array>
#include <atomic>
#include <memory>
#include <span>

namespace idiophone {

/// The references must outlive it. All fields are the audio thread's; `prepare` may use them
/// because no callback runs meanwhile.
class AudioEngine {
public:
    AudioEngine(HostParameters& parameters,
                EngineMessages& messages,
                ProgramChanges& programs,
                EngineReport& report);

    /// [message side] Call while no callback runs. Plays this player from its start, or nothing.
    void prepare(double sampleRateHz, std::unique_ptr<Player> player);
    /// [any thread] Returns whether `prepare` was ever called.
    bool isPrepared() const noexcept { return prepared; }

    /// [audio thread] Plays one block of the host; call it after `prepare`. Neither allocates,
    /// locks nor throws. `playHead` may be null. Clears `midi`.
    void process(juce::AudioBuffer<float>& buffer,
                 juce::MidiBuffer& midi,
                 const juce::AudioPlayHead* playHead,
                 bool isOffline) noexcept;

    /// [any thread, between two callbacks] See PlayedStage::waitForSimulation.
    void waitForSimulation() noexcept {
        if (auto* player = sound.player())
            player->stage().waitForSimulation();
    }

private:
    void takeReset() noexcept;
    Player* takeSound(const juce::MidiBuffer& midi) noexcept;
    void followControllers(const juce::MidiBuffer& midi) noexcept;
    void takeSettings(bool isOffline) noexcept;
    void followTransport(const juce::AudioPlayHead* playHead, int blockSamples) noexcept;
    void takeWindowEvents() noexcept;
    void strikeKeysHeldFor(const Player* next) noexcept;
    void takeEvents(const BlockPieces::Piece& piece) noexcept;
    void render(const StereoSpan& rendered, std::span<const MidiEvent> events) noexcept;
    void followGivenBends(Player& player) noexcept;
    void write(const StereoSpan& rendered, std::span<float* const> channels) noexcept;
    void sendReport(std::span<float* const> channels, int count) noexcept;
    void forgetEvents() noexcept;
    std::span<float* const> channelsFrom(juce::AudioBuffer<float>& buffer, int start) noexcept;

    HostParameters& parameters;
    EngineMessages& messages;
    ProgramChanges& programs;
    EngineReport& report;
    std::atomic<bool> prepared{false};

    ParameterValues values; ///< of this callback
    PlayerCrossfade sound;
    HostTransport transport;
    BlockPieces pieces;
    OutputStage output;
    std::array<float, BlockPieces::maximumSamples> left{}, right{};
    std::array<float*, 2> channelPointers{};
};

} // namespace idiophone
