// The part of Player that follows keys, pedals and wheels.
#include "Instrument/MidiControllers.h"
#include "Instrument/Player.h"

#include <algorithm>

namespace idiophone {
namespace {

constexpr double softestShare = 0.5; // share of the mallet's speed with the soft pedal fully down

/// Includes Reset All Controllers.
bool isChannelMode(const MidiEvent& event) {
    return (event.bytes[0] & 0xf0) == 0xb0 && (event.bytes[1] & 0x7f) >= midi::allSoundOff;
}

bool isPressure(const MidiEvent& event) {
    const int kind = event.bytes[0] & 0xf0;
    return kind == 0xa0 || kind == 0xd0;
}

double pressureOf(const MidiEvent& event) {
    return (event.bytes[(event.bytes[0] & 0xf0) == 0xa0 ? 2 : 1] & 0x7f) / 127.0;
}

} // namespace

// State of keys, pedals and wheels changes at the event's sample, so that a key struck again is
// down by the next grid point. The sound follows at that grid point.

/// Returns the events whose notes strike: those after the last All Sound Off.
std::span<const MidiEvent> Player::follow(std::span<const MidiEvent> eventsOfOneSample) {
    // If one note ends and the next begins on a channel at one sample, wheel and pressure events
    // belong to the next note. They may come first: JUCE's VST3 wrapper sends them before the notes
    // of their sample.
    for (const auto& event : eventsOfOneSample)
        if (event.isNoteOff())
            letGo(event.bytes[0] & 0x0f, event.bytes[1] & 0x7f);
    auto striking = eventsOfOneSample, pressures = eventsOfOneSample;
    for (std::size_t k = 0; k < eventsOfOneSample.size(); ++k) {
        const auto& event = eventsOfOneSample[k];
        follow(event);
        if (midi::isAllSoundOff(event.bytes))
            striking = eventsOfOneSample.subspan(k + 1);
        if (isChannelMode(event)) // a channel mode message resets pressures
            pressures = eventsOfOneSample.subspan(k + 1);
    }
    pressNewKeys(pressures);
    return striking;
}

/// Runs after all events of a sample. A new key takes the last pressure of that sample, even if it
/// came before the key. Pressure 0 before a key is ignored, because MPE keyboards begin a note with
/// it.
void Player::pressNewKeys(std::span<const MidiEvent> events) {
    std::array<std::bitset<128>, 16> pressedLater, waiting;
    for (auto event = events.rbegin(); event != events.rend(); ++event) {
        const int channel = event->bytes[0] & 0x0f;
        std::bitset<128> reached;
        reached.set(event->bytes[1] & 0x7f);
        if (event->isNoteOn())
            waiting[std::size_t(channel)] |= reached & ~pressedLater[std::size_t(channel)];
        if (!isPressure(*event))
            continue;
        PitchBend::Channels channels{channel, channel};
        if ((event->bytes[0] & 0xf0) == 0xd0) {
            channels = bend.reachOf(channel);
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

void Player::follow(const MidiEvent& event) {
    const int kind = event.bytes[0] & 0xf0;
    const int channel = event.bytes[0] & 0x0f;
    const int first = event.bytes[1] & 0x7f;
    const int second = event.bytes[2] & 0x7f;
    if (event.isNoteOn())
        keyDown(channel, first, second);
    else if (event.isNoteOff())
        keyUp(channel, first);
    else if (kind == 0xa0)
        press(channel, first, pressureOf(event));
    else if (kind == 0xb0)
        controller(channel, first, second);
    else if (kind == 0xd0)
        press(channel, pressureOf(event));
    else if (kind == 0xe0)
        bend.wheel(channel, first, second);
}

void Player::keyDown(int channel, int note, int velocity) {
    if (!slotTuning.sounds(note))
        return;
    bend.noteOn(channel, note);
    slotTuning.noteOn(note);
    playedResizedKeys = playedResizedKeys || !playedInstrument->hasOwn(note);
    setKeyPressure(channel, static_cast<std::size_t>(note), 0);
    keysDown[static_cast<std::size_t>(channel)].set(static_cast<std::size_t>(note));
    forgetSilenced();
    if (!strikes(current) && !performance)
        held.press(channel, note, softness * velocity / 127.0);
    playedLast = static_cast<std::size_t>(playedInstrument->key(note).slot);
}

void Player::keyUp(int channel, int note) {
    const auto index = static_cast<std::size_t>(note);
    auto& down = keysDown[static_cast<std::size_t>(channel)];
    if (sustainPedal && down[index])
        keysSustained.set(index);
    down.reset(index);
    setKeyPressure(channel, index, 0);
    letGo(channel, note);
}

/// From now on the channel's wheel and pressure do not act on the note.
void Player::letGo(int channel, int note) {
    bend.noteOff(channel, note);
    held.release(channel, note);
}

/// Pressure is the force of a held contact, or the force of the hand that damps a struck object.
void Player::press(int channel, int note, double pressure) {
    held.setPressure(channel, note, pressure);
    if (keysDown[static_cast<std::size_t>(channel)][static_cast<std::size_t>(note)])
        setKeyPressure(channel, static_cast<std::size_t>(note), pressure);
}

void Player::press(int channel, double pressure) {
    const auto [first, last] = bend.reachOf(channel);
    for (int each = first; each <= last; ++each) {
        held.setPressure(each, pressure);
        const auto& down = keysDown[static_cast<std::size_t>(each)];
        for (std::size_t note = 0; note < down.size(); ++note)
            if (down[note])
                setKeyPressure(each, note, pressure);
    }
}

void Player::setKeyPressure(int channel, std::size_t note, double pressure) {
    keyPressures[static_cast<std::size_t>(channel)][note] = static_cast<float>(pressure);
    notePressures[note] = 0;
    for (const auto& keys : keyPressures)
        notePressures[note] = std::max(notePressures[note], keys[note]);
}

void Player::forgetPressures() {
    keyPressures = {};
    notePressures = {};
}

/// Holds the keys that are down when the sostenuto pedal goes down, until it is up again. After
/// that the sustain pedal holds them if it is down.
void Player::catchKeys(bool isDown) {
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

void Player::takeControllersOf(const Player& former) noexcept {
    takeBendSetupOf(former);
    bend.takeWheelsOf(former.bend);
    sustainPedal = former.sustainPedal;
    sostenutoPedal = former.sostenutoPedal;
    isSilenced = former.isSilenced; // the room behind the player fades under the same All Sound Off
    softness = former.softness;
    held.takeControllersOf(former.held);
    loudness.setSpeedController(former.loudness.speedController());
}

void Player::takeBendSetupOf(const Player& former) noexcept {
    bend.takeSetupOf(former.bend);
}

void Player::liftPedals() {
    sustainPedal = sostenutoPedal = false;
    keysSustained.reset();
    keysCaught.reset();
    softness = 1;
}

void Player::controller(int channel, int number, int value) {
    bend.controller(channel, number, value);
    const auto [first, last] = bend.reachOf(channel);
    switch (number) {
    case midi::modulation:
        for (int each = first; each <= last; ++each)
            held.setSpeedController(each, value);
        loudness.setSpeedController(value);
        break;
    case midi::place:
        for (int each = first; each <= last; ++each)
            held.setPlaceController(each, value);
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
        softness = 1 - (1 - softestShare) * value / 127.0;
        break;
    case midi::allSoundOff:
        isSilenced = true;
        allSoundOffCame = true;
        if (performance)
            performance->stop();
        pending.clear();
        late.clear();
        surfaceStrikes.clear();
        [[fallthrough]];
    case midi::allNotesOff:
    case midi::omniOff:
    case midi::omniOn:
    case midi::monoOn:
    case midi::polyOn:
        liftHands();
        held.releaseAll();
        bend.releaseNotes();
        keysDown = {};
        forgetPressures();
        keysSustained.reset();
        keysCaught.reset();
        break;
    case midi::resetControllers:
        liftPedals();
        for (int each = first; each <= last; ++each) {
            held.resetControllers(each);
            for (std::size_t note = 0; note < notePressures.size(); ++note)
                setKeyPressure(each, note, 0);
        }
        loudness.setSpeedController(HeldContacts::controllerAtRest);
        break;
    default:
        break;
    }
}

} // namespace idiophone
