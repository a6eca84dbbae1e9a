// Holds the sound that is loaded, and plays others: builds a player for each and hands it to the
// audio engine.
#pragma once

#include "Editor/StatusView.h"
#include "Plugin/SharedParts.h"
#include "Plugin/Sound.h"

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>

namespace idiophone {

/// Every field is under the lock, which the audio thread never takes. Functions marked [lock] need
/// the caller to hold it; the others take it themselves and may come from any other thread.
class SoundSession final : public SoundHolder, public StatusView {
public:
    using LoadValues = std::function<void()>;
    using PlayerResult = Result<std::unique_ptr<Player>>;

    /// The sound that plays and the number of its load. A sound made from it is played only if no
    /// other thread has loaded a sound since.
    struct Loaded {
        Sound sound;
        int number = 0;
        int origin = 0; ///< see `origin`
    };

    explicit SoundSession(SharedParts& sharedParts) : shared(sharedParts) {}

    [[nodiscard]] std::unique_lock<std::mutex> lock() const { return std::unique_lock(mutex); }

    /// Prepares for this rate; `install` gets the player of the loaded sound, or null. It is called
    /// with the lock, while no callback runs.
    void prepare(double sampleRateHz, const std::function<void(std::unique_ptr<Player>)>& install);
    /// [message thread] Reports an output that was not finite, destroys players that faded out,
    /// stores the impacts of a stage's bodies and predicts the gain that matches loudness. If
    /// another thread holds the lock, waits for the next poll.
    void poll();

    Sound loadedSound() const override;
    PlayingPreset playingPreset() const override;
    /// Returns the values of the playing preset as it was loaded or saved.
    ParameterValues presetValues() const;
    bool playSound(const Sound& wanted) override;
    void relabel(const Sound& wanted) override;
    void changeParameters(const Sound& of, const ParameterValues& wanted) override;
    Status takeStatus() override;
    void reportError(const std::string& sentence) override;
    /// Removes this error from the status line, unless another has replaced it.
    void takeBackError(const std::string& sentence);

    Loaded loaded() const;
    /// Returns the playing instrument, or null if none could be loaded.
    std::shared_ptr<const Instrument> instrument() const;
    /// Returns the prepared rate, or before preparation a usual one.
    double rateHz() const;
    /// Changes with each load.
    int number() const noexcept { return loads; }
    /// Returns the number of the load that brought the objects. Undo steps between key layouts of
    /// one object keep it, and so do edits of a kit; another preset of the same object does not.
    int origin() const noexcept { return loadOfObjects; }
    /// Returns the factory program that plays, or −1.
    int program() const noexcept { return playingProgram; }

    /// [lock]
    Sound& playing() noexcept { return current; }
    /// [lock] Returns the sound with the values of the parameters.
    Sound soundNow() const;
    /// [lock] Shows a sentence in the status line.
    void fail(const std::string& sentence) { lastError = sentence; }
    /// [lock] Call it as the first step of a change: if memory or threads do not suffice, nothing
    /// has changed. The former player sounds on meanwhile with its own values. Returns a player
    /// prepared for `values`, or null without a sample rate or an instrument.
    PlayerResult newPlayer(const std::shared_ptr<const Instrument>& instrument,
                           const Preset& preset,
                           const ParameterValues& values) const;
    /// Returns `newPlayer` of an instrument that does not play yet, and the lock. Builds without
    /// the lock, so that the window does not wait.
    std::pair<PlayerResult, std::unique_lock<std::mutex>>
    newPlayerThenLock(const std::shared_ptr<const Instrument>& instrument,
                      const Preset& preset,
                      const ParameterValues& values) const;
    /// [lock] Plays a sound with the player from `newPlayer`. `loadValues` sets the parameter
    /// values.
    void play(Sound sound, std::unique_ptr<Player> player, const LoadValues& loadValues);
    /// [lock] Call it after `play` if the sound has the objects of that earlier load.
    void keepOrigin(int load) noexcept { loadOfObjects = load; }
    /// [lock]
    ModeSet& modesHeardAlone() noexcept { return heardAlone; }
    void sendSilences();

private:
    bool goesOnWith(const Sound& wanted) const;
    PlayerResult playerForLevel(const Preset& preset, const ParameterValues& values) const;
    void goOn(std::unique_ptr<Player> player, const LoadValues& loadValues);
    void handOver(std::unique_ptr<Player> player, const LoadValues& loadValues);

    SharedParts& shared;

    mutable std::mutex mutex;
    Sound current; ///< its `parameters` are not kept up to date: see `soundNow`
    ModeSet heardAlone;
    std::string lastError;
    std::shared_ptr<MatchedGain> playedGain; ///< of the last player, or null
    double preparedRateHz = 0;               ///< 0 until prepared
    // Written under the lock, read by any thread.
    std::atomic<int> loads{0}, loadOfObjects{0}, playingProgram{-1};
    std::int64_t notFiniteShown = 0; ///< the message thread's
};

} // namespace idiophone
