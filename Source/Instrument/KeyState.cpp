#include "Instrument/KeyState.h"

#include "Instrument/MidiControllers.h"

#include <algorithm>

namespace idiophone {
namespace {

constexpr double softestFactor = 0.5; // of the mallet's speed, with the soft pedal fully down

bool isPressure(const MidiEvent& event) {
    return event.kind() == 0xa0 || event.kind() == 0xd0;
}

double pressureOf(const MidiEvent& event) {
    return (event.kind() == 0xa0 ? event.second() : event.first()) / 127.0;
}

} // namespace

void KeyState::beginSample(std::span<const MidiEvent> events) noexcept {
    for (const auto& event : events)
        if (event.isNoteOff())
            letGo(event.channel(), event.first());
}

void KeyState::follow(const MidiEvent& event) noexcept {
    const int channel = event.channel();
    if (event.isNoteOn())
        keyDown(channel, event.first());
    else if (event.isNoteOff())
        keyUp(channel, event.first());
    else if (event.kind() == 0xa0)
        press(channel, event.first(), pressureOf(event));
    else if (event.kind() == 0xb0)
        controller(channel, event.first(), event.second());
    else if (event.kind() == 0xd0)
        pressChannel(channel, pressureOf(event));
    else if (event.kind() == 0xe0)
        pitchBend.wheel(channel, event.first(), event.second());
}

void KeyState::endSample(std::span<const MidiEvent> events) noexcept {
    std::array<Keys, 16> pressedLater, waiting;
    for (auto event = events.rbegin(); event != events.rend(); ++event) {
        if (midi::isChannelMode(event->bytes)) // a channel mode has reset earlier pressures
            return;
        const int channel = event->channel();
        Keys reached;
        reached.set(static_cast<std::size_t>(event->first()));
        if (event->isNoteOn())
            waiting[std::size_t(channel)] |= reached & ~pressedLater[std::size_t(channel)];
        if (!isPressure(*event))
            continue;
        PitchBend::Channels channels{channel, channel};
        if (event->kind() == 0xd0) {
            channels = pitchBend.reachOf(channel);
            reached.set();
        }
        for (int each = channels.first; each <= channels.last; ++each) {
            auto& keys = waiting[std::size_t(each)];
            const auto pressed = keys & reached;
            for (std::size_t key = 0; pressed.any() && key < pressed.size(); ++key)
                if (pressed[key] && pressureOf(*event) > 0)
                    press(each, static_cast<int>(key), pressureOf(*event));
            keys &= ~reached;
            pressedLater[std::size_t(each)] |= reached;
        }
    }
}

KeyState::Keys KeyState::heldKeys() const noexcept {
    auto keys = keysSustained | keysCaught;
    for (const auto& down : keysDown)
        keys |= down;
    return keys;
}

void KeyState::keyDown(int channel, int note) noexcept {
    pitchBend.noteOn(channel, note);
    setKeyPressure(channel, static_cast<std::size_t>(note), 0);
    keysDown[static_cast<std::size_t>(channel)].set(static_cast<std::size_t>(note));
}

void KeyState::keyUp(int channel, int note) noexcept {
    const auto index = static_cast<std::size_t>(note);
    auto& down = keysDown[static_cast<std::size_t>(channel)];
    if (sustainPedal && down[index])
        keysSustained.set(index);
    down.reset(index);
    setKeyPressure(channel, index, 0);
    letGo(channel, note);
}

/// From now on the channel's wheel and pressure do not act on the note.
void KeyState::letGo(int channel, int note) noexcept {
    pitchBend.noteOff(channel, note);
    held.release(channel, note);
}

/// Pressure is the force of a held contact, or the force of the hand that damps a struck object.
void KeyState::press(int channel, int note, double pressure) noexcept {
    held.setPressure(channel, note, pressure);
    if (keysDown[static_cast<std::size_t>(channel)][static_cast<std::size_t>(note)])
        setKeyPressure(channel, static_cast<std::size_t>(note), pressure);
}

void KeyState::pressChannel(int channel, double pressure) noexcept {
    const auto [first, last] = pitchBend.reachOf(channel);
    for (int each = first; each <= last; ++each) {
        held.setPressure(each, pressure);
        const auto& down = keysDown[static_cast<std::size_t>(each)];
        for (std::size_t note = 0; note < down.size(); ++note)
            if (down[note])
                setKeyPressure(each, note, pressure);
    }
}

void KeyState::setKeyPressure(int channel, std::size_t note, double pressure) noexcept {
    keyPressures[static_cast<std::size_t>(channel)][note] = static_cast<float>(pressure);
    notePressures[note] = 0;
    for (const auto& keys : keyPressures)
        notePressures[note] = std::max(notePressures[note], keys[note]);
}

void KeyState::controller(int channel, int number, int value) noexcept {
    pitchBend.controller(channel, number, value);
    const auto [first, last] = pitchBend.reachOf(channel);
    switch (number) {
    case midi::modulation:
        for (int each = first; each <= last; ++each)
            held.controllers(each).speed = value;
        modulation = value;
        wheelMoved = true;
        break;
    case midi::place:
        for (int each = first; each <= last; ++each)
            held.controllers(each).place = value;
        break;
    case midi::sustainPedal:
        sustainPedal = value >= 64;
        if (!sustainPedal)
            keysSustained.reset();
        break;
    case midi::sostenutoPedal:
        catchKeys(value >= 64);
        break;
    case midi::softPedal:
        softPedalFactor = 1 - (1 - softestFactor) * value / 127.0;
        break;
    case midi::resetControllers:
        resetControllers({first, last});
        break;
    default:
        if (midi::releasesAllNotes(number))
            releaseAll();
        break;
    }
}

/// Holds the keys that are down when the sostenuto pedal goes down, until it is up again. After
/// that the sustain pedal holds them if it is down.
void KeyState::catchKeys(bool isDown) noexcept {
    if (isDown == sostenutoPedal)
        return;
    sostenutoPedal = isDown;
    if (sustainPedal)
        keysSustained |= keysCaught;
    keysCaught.reset();
    if (isDown)
        for (const auto& down : keysDown)
            keysCaught |= down;
}

void KeyState::releaseAll() noexcept {
    held.releaseAll();
    pitchBend.releaseNotes();
    keysDown = {};
    keyPressures = {};
    notePressures = {};
    keysSustained.reset();
    keysCaught.reset();
}

void KeyState::resetControllers(PitchBend::Channels reached) noexcept {
    liftPedals();
    for (int each = reached.first; each <= reached.last; ++each) {
        held.resetControllers(each);
        for (std::size_t note = 0; note < notePressures.size(); ++note)
            setKeyPressure(each, note, 0);
    }
    modulation = HeldContacts::controllerAtRest;
    wheelMoved = false;
}

void KeyState::liftPedals() noexcept {
    sustainPedal = sostenutoPedal = false;
    keysSustained.reset();
    keysCaught.reset();
    softPedalFactor = 1;
}

void KeyState::takeControllersOf(const KeyState& former) noexcept {
    pitchBend.takeSetupOf(former.pitchBend);
    pitchBend.takeWheelsOf(former.pitchBend);
    sustainPedal = former.sustainPedal;
    sostenutoPedal = former.sostenutoPedal;
    softPedalFactor = former.softPedalFactor;
    modulation = former.modulation;
    wheelMoved = former.wheelMoved;
    held.takeControllersOf(former.held);
}

void KeyState::reset() noexcept {
    releaseAll();
    liftPedals();
    modulation = HeldContacts::controllerAtRest;
    wheelMoved = false;
    held.reset();
    pitchBend.reset();
}

} // namespace idiophone
