// How a player follows keys, pedals and wheels.
#include "Instrument/Player.h"

#include <algorithm>

namespace idiophone {
namespace {

enum ControllerNumber {
    modulationController = 1,
    sustainController = 64,
    sostenutoController = 66,
    softController = 67,
    placeController = 74,
    allSoundOff = 120,
    resetControllers,
    allNotesOff = 123
};

constexpr double softestShare = 0.5; // of the mallet's speed, with the soft pedal all down

} // namespace

// Keys, pedals and wheels are followed at their sample, so that a key struck again is down again by
// the next grid point; what follows for the sound happens there.
void Player::follow(const MidiEvent& event) {
    const int kind = event.bytes[0] & 0xf0;
    const int channel = event.bytes[0] & 0x0f;
    const int first = event.bytes[1] & 0x7f;
    const int second = event.bytes[2] & 0x7f;
    if (event.isNoteOn())
        keyDown(channel, first, second);
    else if (kind == 0x80 || kind == 0x90)
        keyUp(channel, first);
    else if (kind == 0xa0)
        held.setPressure(channel, first, second / 127.0);
    else if (kind == 0xb0)
        controller(channel, first, second);
    else if (kind == 0xc0)
        programChange = first;
    else if (kind == 0xd0)
        held.setPressure(channel, first / 127.0);
    else if (kind == 0xe0)
        bend = std::clamp((second * 128 + first - 8192) / 8191.0, -1.0, 1.0);
}

void Player::keyDown(int channel, int note, int velocity) {
    keysDown[static_cast<std::size_t>(channel)].set(static_cast<std::size_t>(note));
    if (!strikes(current))
        held.press(channel, note, softness * velocity / 127.0);
    if (const auto slot = playedInstrument->key(note).slot; slot >= 0) {
        slotSilenced[static_cast<std::size_t>(slot)] = false;
        playedLast = static_cast<std::size_t>(slot);
    }
}

void Player::keyUp(int channel, int note) {
    const auto index = static_cast<std::size_t>(note);
    auto& down = keysDown[static_cast<std::size_t>(channel)];
    if (sustainPedal && down[index])
        keysSustained.set(index);
    down.reset(index);
    held.release(channel, note);
}

/// Keys that are down when the sostenuto pedal goes down are held until it is up again.
void Player::catchKeys(bool isDown) {
    if (isDown == sostenutoPedal)
        return;
    sostenutoPedal = isDown;
    keysCaught.reset();
    if (isDown)
        for (const auto& down : keysDown)
            keysCaught |= down;
}

void Player::liftPedals() {
    sustainPedal = sostenutoPedal = false;
    keysSustained.reset();
    keysCaught.reset();
    softness = 1;
}

void Player::controller(int channel, int number, int value) {
    switch (number) {
    case modulationController:
        held.setSpeedController(channel, value);
        loudness.setSpeedController(value);
        break;
    case placeController:
        held.setPlaceController(channel, value);
        break;
    case sustainController:
        sustainPedal = value >= 64;
        if (!sustainPedal)
            keysSustained.reset();
        break;
    case sostenutoController:
        catchKeys(value >= 64);
        break;
    case softController:
        softness = 1 - (1 - softestShare) * value / 127.0;
        break;
    case allSoundOff:
        std::fill(slotSilenced.begin(), slotSilenced.end(), true);
        pending.clear();
        late.clear();
        surfaceStrikes.clear();
        [[fallthrough]];
    case allNotesOff:
        liftHands();
        held.releaseAll();
        keysDown = {};
        keysSustained.reset();
        keysCaught.reset();
        break;
    case resetControllers:
        liftPedals();
        bend = 0;
        held.resetControllers(channel);
        loudness.setSpeedController(HeldContacts::controllerAtRest);
        break;
    default:
        break;
    }
}

} // namespace idiophone
