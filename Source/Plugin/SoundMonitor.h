// Takes a picture of the sound for the window, on the audio thread. Takes one some 30 times per
// second of the stream while the window asks, and hands it over whole. Changes nothing.
#pragma once

#include "Instrument/LatestValue.h"
#include "Instrument/Player.h"
#include "Plugin/PlayerCrossfade.h"
#include "Synth/SoundingGroups.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <juce_audio_basics/juce_audio_basics.h>
#include <memory>
#include <optional>

namespace idiophone {

/// The state at the end of a callback.
struct MonitoredSound {
    static constexpr std::size_t maximumModes = 8192; ///< of an object; further modes are not shown
    static constexpr std::size_t maximumSlots = 128;

    std::uint64_t instrument = 0; ///< its serial number
    double sampleRateHz = 0;
    std::size_t slot = 0; ///< slot of `groups`
    SoundingGroups groups{maximumModes};
    std::size_t slotCount = 0;
    std::array<Synthesiser::SlotStatus, maximumSlots> slots{};
    std::size_t bodyCount = 0; ///< number of a stage's slots, or 0
    std::array<BodyPose, maximumSlots> bodies{};
    int velocity = 0; ///< of the mallet's last strike, 1 to 127; 0: none
    double qualitySlope = 1;
    double modeBudget = 0;
    float load = 0;               ///< of one processor core, 0 to 1
    std::array<float, 2> peaks{}; ///< of each output channel since the last picture
};

class SoundMonitor {
public:
    /// [message side] Call while no callback runs.
    void prepare(double sampleRateHz);

    /// [message thread] Returns the newest picture since the last call, valid until the next call,
    /// or nullptr. Calling makes the audio thread take the next one. The first call allocates.
    const MonitoredSound* take();

    /// [message thread] Chooses the slot of `instrument` to show. Of slots that share its object,
    /// shows the slot played last. If no slot is chosen, shows the slot played last of all.
    void watch(std::optional<std::size_t> slot) noexcept {
        watchedSlot = slot ? static_cast<int>(*slot) : -1;
    }

    /// [audio thread] One object per callback measures its duration for display and takes a picture
    /// if one is due. Neither allocates, locks nor throws. Does nothing if no window asks.
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

    /// [audio thread] Notes a peak of the output, full scale 1.
    void addPeak(std::size_t channel, float peak) noexcept;

private:
    void takePicture(const Player& player) noexcept;
    std::size_t slotToShow(const Player& player) const noexcept;

    std::unique_ptr<LatestValue<MonitoredSound>> latest; ///< created before `wanted` is first set
    std::atomic<bool> wanted{false};
    std::atomic<int> watchedSlot{-1};

    // Owned by the audio thread.
    double rateHz = 44100;
    double watchedSamples = 0; ///< samples for which to go on measuring
    double samplesSincePicture = 0;
    std::array<float, 2> peaks{};
    juce::AudioProcessLoadMeasurer load;
};

} // namespace idiophone
