// What the window shows of the sound, taken on the audio thread some 30 times a second of the
// stream while somebody asks, and handed over whole. It only looks.
#pragma once

#include "Instrument/Player.h"
#include "Plugin/LatestValue.h"
#include "Plugin/PlayerCrossfade.h"
#include "Synth/SoundingGroups.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <juce_audio_basics/juce_audio_basics.h>
#include <memory>
#include <optional>

namespace idiophone {

/// As of the end of a callback.
struct MonitoredSound {
    static constexpr std::size_t mostModes = 8192; ///< of an object; those beyond are not shown
    static constexpr std::size_t mostSlots = 128;

    std::uint64_t instrument = 0; ///< its serial number
    double sampleRateHz = 0;
    std::size_t slot = 0; ///< whose groups these are
    SoundingGroups groups{mostModes};
    std::size_t slotCount = 0;
    std::array<Synthesiser::SlotStatus, mostSlots> slots{};
    std::size_t bodyCount = 0; ///< of a stage's slots, or 0
    std::array<BodyPose, mostSlots> bodies{};
    double qualitySlope = 1;
    double modeBudget = 0;
    float load = 0;               ///< of one processor, 0 to 1
    std::array<float, 2> peaks{}; ///< of each output channel since the one before
};

class SoundMonitor {
public:
    /// [message side] while no callback runs.
    void prepare(double sampleRateHz);

    /// [message thread] The newest since the last call, valid until the next one, or nullptr.
    /// Asking is what makes the audio thread look. The first call allocates.
    const MonitoredSound* take();

    /// [message thread] The slot of `instrument` to look at, or of those that share its object the
    /// one played last; nothing: always the one played last.
    void watch(std::optional<std::size_t> slot) noexcept {
        watchedSlot = slot ? static_cast<int>(*slot) : -1;
    }

    /// [audio thread] One callback, from construction to destruction: measures its time, which is
    /// only shown, and looks when it is due. Neither allocates, locks nor throws; costs nothing
    /// while nobody asks.
    class Callback {
    public:
        Callback(SoundMonitor& monitor, const PlayerCrossfade& sound, int samples) noexcept;
        ~Callback();
        Callback(const Callback&) = delete;
        Callback& operator=(const Callback&) = delete;

    private:
        SoundMonitor& monitor;
        const PlayerCrossfade& sound;
        int samples;
        std::optional<juce::AudioProcessLoadMeasurer::ScopedTimer> timer;
    };

    /// [audio thread] What was played since, full scale 1.
    void hear(std::size_t channel, float peak) noexcept;

private:
    void look(const Player& player) noexcept;
    std::size_t slotToShow(const Player& player) const noexcept;

    std::unique_ptr<LatestValue<MonitoredSound>> latest; ///< made before `wanted` is first set
    std::atomic<bool> wanted{false};
    std::atomic<int> watchedSlot{-1};

    // The audio thread's.
    double rateHz = 44100;
    double watchedSamples = 0; ///< for which it goes on to measure
    double samplesSinceLook = 0;
    std::array<float, 2> peaks{};
    juce::AudioProcessLoadMeasurer load;
};

} // namespace idiophone
