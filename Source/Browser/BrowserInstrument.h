// The instrument that a web page plays: presets, MIDI, parameters and the output stage.
#pragma once

#include "Browser/FetchedObjects.h"
#include "Instrument/Player.h"
#include "Output/OutputStage.h"
#include "World/ObjectSurface.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace idiophone {

/// One thread, which in an AudioWorklet is the audio thread: between its callbacks it handles
/// messages. Only `send` and `render` belong in a callback; they neither allocate nor throw, unless
/// an offline scene is simulated.
class BrowserInstrument {
public:
    static constexpr std::size_t maximumFrames = 128;

    /// `isOffline`: renders may wait for what is late in real time (Player::setOffline).
    BrowserInstrument(double sampleRateHz, bool isOffline);

    FetchedObjects& objects() { return fetched; }

    // The next three play a sound from the next block on. On an error the former sound goes on.
    /// Plays a factory preset, whose objects must have been added.
    Result<void> loadFactory(std::string_view name);
    /// Plays a preset file's text; `name` stands for it in errors.
    Result<void> loadText(std::string_view text, std::string_view name);
    /// Plays an added object on all keys, as loud as the factory presets.
    Result<void> loadObject(const std::string& name);

    /// Return what plays, or null before the first load.
    const Preset* preset() const { return played ? &*played : nullptr; }
    const Instrument* instrument() const { return player ? &player->instrument() : nullptr; }
    /// Returns a slot for each object that plays (ownSlots).
    const std::vector<std::size_t>& slots() const { return slotsOfObjects; }

    const ParameterValues& values() const { return current; }
    void set(ParameterId parameter, double value) { current.set(parameter, value); }

    /// Queues a MIDI message for the next block, in order of time; drops it if there are thousands.
    /// Callbacks may call it.
    void send(const MidiEvent& event) {
        if (events.size() < events.capacity())
            events.push_back(event);
    }
    /// Strikes the object of that index (`slots`) at the place nearest to a point, in metres of its
    /// own mesh. Velocity is 1 to 127; 0 lifts the hand. Ignores objects that do not exist.
    void strike(std::size_t object, const std::array<double, 3>& pointMetres, int velocity);
    /// Drags a hand over the object; pressure 0 lifts it.
    void scrape(std::size_t object, const std::array<double, 3>& pointMetres, double pressure);
    /// Silences everything and lifts all hands and keys.
    void silence();

    /// Does what other threads do elsewhere: predicts the gain that matches loudness, and simulates
    /// a scene some ms ahead. Call it every 10 ms or so, outside of callbacks.
    void work();

    /// Returns eight numbers for each slot of a scene, otherwise nothing: 1 if its body is there,
    /// the origin in metres, and the turn as a quaternion x, y, z, w (BodyPose). Valid until the
    /// next call.
    std::span<const float> poses();

    /// Renders the next frames, at most `maximumFrames`. Valid until the next call.
    StereoSpan render(std::size_t frames);

private:
    Result<void> load(Preset preset);
    void play(Preset preset, std::shared_ptr<const Instrument> instrument);
    const ObjectSurface& surfaceOf(std::size_t object);

    const double rateHz;
    const bool isOffline;
    FetchedObjects fetched;
    OutputStage output;
    ParameterValues current;
    std::optional<Preset> played;
    std::unique_ptr<Player> player; ///< null before the first load
    std::vector<std::size_t> slotsOfObjects;
    std::vector<std::unique_ptr<ObjectSurface>> surfaces; ///< [objects] null until touched
    std::vector<MidiEvent> events;
    std::vector<float> poseNumbers;
    std::array<float, maximumFrames> left{}, right{};
};

} // namespace idiophone
