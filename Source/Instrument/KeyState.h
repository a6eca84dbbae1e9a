// Follows MIDI: which keys are held, how hard they are pressed, the pedals, and how wheels bend.
#pragma once

#include "Instrument/HeldContacts.h"
#include "Instrument/MidiEvent.h"
#include "Instrument/PitchBend.h"

#include <array>
#include <bitset>
#include <cstddef>
#include <span>

namespace idiophone {

/// For the audio thread; neither allocates, locks nor throws. State changes at the event's sample,
/// so that a key struck again is down by the next grid point. The owner starts contacts; releases,
/// pressures and controllers are passed on to them.
class KeyState {
public:
    using Keys = std::bitset<128>;

    /// The contacts must outlive the state.
    explicit KeyState(HeldContacts& contacts) : held(contacts) {}

    /// Call before the events of one sample. If one note ends and the next begins on a channel at
    /// one sample, wheel and pressure events belong to the next note. These events may come before
    /// the note: JUCE's VST3 wrapper sends them first.
    void beginSample(std::span<const MidiEvent> events) noexcept;
    void follow(const MidiEvent& event) noexcept;
    /// Call after the events of one sample. A new key takes the last pressure of that sample, even
    /// if it came before the key. Pressure 0 before a key is ignored, because MPE keyboards begin a
    /// note with it.
    void endSample(std::span<const MidiEvent> events) noexcept;

    Keys heldKeys() const noexcept; ///< down, or held by a pedal
    /// Returns the maximum pressure of a note's keys over all channels, 0 to 1.
    float pressure(std::size_t note) const noexcept { return notePressures[note]; }
    /// Returns the soft pedal's factor of the mallet's speed.
    double softness() const noexcept { return softPedalFactor; }
    int modulationWheel() const noexcept { return modulation; } ///< 0 to 127
    /// Returns the wheel's position from 0 to 1. Before it moves it counts as down.
    double wheelForModulation() const noexcept { return wheelMoved ? modulation / 127.0 : 0; }
    PitchBend& bend() noexcept { return pitchBend; }
    const PitchBend& bend() const noexcept { return pitchBend; }

    /// Takes over pedals, wheels and other controllers, but not keys.
    void takeControllersOf(const KeyState& former) noexcept;
    /// Releases all keys and resets controllers. Keeps MPE's zones and bend ranges.
    void reset() noexcept;

private:
    void letGo(int channel, int note) noexcept;
    void keyDown(int channel, int note) noexcept;
    void keyUp(int channel, int note) noexcept;
    void press(int channel, int note, double pressure) noexcept;
    void pressChannel(int channel, double pressure) noexcept;
    void setKeyPressure(int channel, std::size_t note, double pressure) noexcept;
    void controller(int channel, int number, int value) noexcept;
    void catchKeys(bool isDown) noexcept;
    void releaseAll() noexcept;
    void resetControllers(PitchBend::Channels reached) noexcept;
    void liftPedals() noexcept;

    HeldContacts& held;
    PitchBend pitchBend;
    std::array<Keys, 16> keysDown; ///< [channel][note]
    Keys keysSustained;            ///< released under the sustain pedal
    Keys keysCaught;               ///< down when the sostenuto pedal went down
    bool sustainPedal = false;
    bool sostenutoPedal = false;
    double softPedalFactor = 1;
    int modulation = HeldContacts::controllerAtRest;
    bool wheelMoved = false;                               ///< since the last reset of controllers
    std::array<std::array<float, 128>, 16> keyPressures{}; ///< [channel][note] 0 to 1
    std::array<float, 128> notePressures{};                ///< [note] maximum over channels
};

} // namespace idiophone
