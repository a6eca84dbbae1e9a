// Turns MIDI into sound, callback by callback. It owns everything of the audio thread and knows
// neither the host nor the session, only their messages.
#pragma once

#include "Output/DryWet.h"
#include "Plugin/BlockPieces.h"
#include "Plugin/EngineMessages.h"
#include "Plugin/EngineReport.h"
#include "Plugin/HostTransport.h"
#include "Plugin/OutputBuses.h"
#include "Plugin/PlayerCrossfade.h"
#include "Plugin/ProgramChanges.h"

#include <array>
#include <atomic>
#include <memory>
#include <span>

namespace idiophone {

/// A block of the host. Its first channels hold the input, and are then overwritten by the output.
struct HostBuffer {
    juce::AudioBuffer<float>& samples;
    int inputs = 0; ///< channels that come in, 0 to 2
    /// Channels of each output, 0 to 2, one output after another. 0: not connected.
    std::array<int, maximumOutputs> outputs{2};
    bool isEffect = false; ///< the main output is mixed with the input
};

/// The references must outlive it. All fields are the audio thread's; `prepare` may use them
/// because no callback runs meanwhile.
class AudioEngine {
public:
    AudioEngine(HostParameters& parameters,
                EngineMessages& messages,
                ProgramChanges& programs,
                EngineReport& report);

    /// [message side] Call while no callback runs. Plays this player from its start, or nothing.
    /// Later only these outputs can sound.
    void prepare(double sampleRateHz, std::unique_ptr<Player> player, OutputSet outputs = {1});
    /// [any thread] Returns whether `prepare` was ever called.
    bool isPrepared() const noexcept { return prepared; }

    /// [audio thread] Plays one block of the host; call it after `prepare`. Neither allocates,
    /// locks nor throws. `playHead` may be null. Clears `midi`.
    void process(const HostBuffer& buffer,
                 juce::MidiBuffer& midi,
                 const juce::AudioPlayHead* playHead,
                 bool isOffline) noexcept;

    /// [audio thread] Moves single notes of all players.
    NoteShifts& noteShifts() noexcept { return shifts; }
    /// [audio thread] Returns whether the note, 0 to 127, rings.
    bool sounds(int note) const noexcept {
        const auto* player = sound.player();
        return player != nullptr && player->sounds(note);
    }

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
    void takeInput(const HostBuffer& buffer, const BlockPieces::Piece& piece) noexcept;
    void render(std::span<const StereoSpan> rendered, std::span<const MidiEvent> events) noexcept;
    void followGivenBends(Player& player) noexcept;
    void write(std::span<const StereoSpan> rendered,
               const OutputBuses::Channels& channels) noexcept;
    void sendReport(const OutputBuses::Channels& channels, int count) noexcept;
    void forgetEvents() noexcept;
    OutputBuses::Channels channelsFrom(const HostBuffer& buffer, int start) noexcept;

    HostParameters& parameters;
    EngineMessages& messages;
    ProgramChanges& programs;
    EngineReport& report;
    std::atomic<bool> prepared{false};

    ParameterValues values; ///< of this callback
    NoteShifts shifts;
    PlayerCrossfade sound;
    HostTransport transport;
    BlockPieces pieces;
    OutputBuses output;
    DryWet dryWet;
    std::array<std::array<float, BlockPieces::maximumSamples>, 2> heard{}; ///< the piece's input
    std::array<float, BlockPieces::maximumSamples> pressing{};             ///< its mean
    std::array<std::span<const float>, 2> heardChannels{};
    std::size_t heardCount = 0; ///< channels of the input; 0: none
    std::array<float*, 2 * maximumOutputs> channelPointers{};
};

} // namespace idiophone
