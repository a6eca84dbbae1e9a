#include "Plugin/Tuner.h"

#include "Instrument/Player.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <libMTSClient.h>

namespace idiophone {
namespace {

constexpr char anyChannel = -1;
constexpr double maximumSemitones = 128;

/// A "scale/octave tuning" message, one byte a note, on all channels.
constexpr std::array<juce::uint8, 21> equalTemperament{0xf0, 0x7e, 0x7f, 0x08, 0x08, 0x03, 0x7f,
                                                       0x7f, 64,   64,   64,   64,   64,   64,
                                                       64,   64,   64,   64,   64,   64,   0xf7};

/// Returns whether a message lists single notes, each with its key number, and not a dump of all
/// keys.
bool namesKeys(std::span<const juce::uint8> message) {
    return message[4] == 0x02 || message[4] == 0x07;
}

/// Returns where a message's list of key pitches begins: behind the program, the bank if given, and
/// the name or number of keys. Returns nothing for other messages, such as those for an octave.
std::optional<std::size_t> firstKeyIn(std::span<const juce::uint8> message) {
    switch (message[4]) {
    case 0x01: // bulk dump of a program
        return 22;
    case 0x04: // bulk dump of a bank and program
        return 23;
    case 0x02: // single notes of a program
        return 7;
    case 0x07: // single notes of a bank and program
        return 8;
    default:
        return std::nullopt;
    }
}

} // namespace

void Tuner::Deregister::operator()(MTSClient* registered) const {
    MTS_DeregisterClient(registered);
}

Tuner::Tuner() : client(MTS_RegisterClient()) {}

void Tuner::setOwn(const std::optional<KeyTuning>& tuning) noexcept {
    handoff.next() = tuning;
    handoff.publish();
}

bool Tuner::hasMaster() const {
    return MTS_HasMaster(client.get());
}

std::string Tuner::masterScaleName() const {
    const char* name = MTS_GetScaleName(client.get());
    return name != nullptr ? name : "";
}

void Tuner::retune(std::span<const juce::uint8> message) noexcept {
    // F0, non-real or real time, any device, MIDI Tuning Standard.
    const bool isTuning =
        message.size() > 4 && (message[1] == 0x7e || message[1] == 0x7f) && message[3] == 0x08;
    if (!isTuning)
        return;
    if (const auto first = firstKeyIn(message))
        retuneKeys(message.subspan(std::min(*first, message.size())), namesKeys(message));
    else
        MTS_ParseMIDIDataU(client.get(), message.data(), static_cast<int>(message.size()));
    tunedByMessages = true;
}

/// Sends one message per key, because the client takes "no change" for a pitch.
void Tuner::retuneKeys(std::span<const juce::uint8> keys, bool areNamed) noexcept {
    const std::size_t bytesOfKey = areNamed ? 4 : 3;
    for (std::size_t key = 0; key < KeyTuning::notes && keys.size() > bytesOfKey; ++key) {
        const auto pitch = keys.subspan(areNamed ? 1 : 0, 3);
        const auto number = areNamed ? keys.front() : static_cast<juce::uint8>(key);
        if (std::ranges::any_of(pitch, [](juce::uint8 byte) { return byte != 0x7f; })) {
            const std::array<juce::uint8, 12> single{0xf0,     0x7f,     0x7f,     0x08,
                                                     0x02,     0x00,     0x01,     number,
                                                     pitch[0], pitch[1], pitch[2], 0xf7};
            MTS_ParseMIDIDataU(client.get(), single.data(), static_cast<int>(single.size()));
        }
        keys = keys.subspan(bytesOfKey);
    }
}

/// Only a message makes the client forget a tuning: zero offset for all twelve notes.
void Tuner::followForgetting() noexcept {
    if (!forgetsMessages)
        return;
    if (tunedByMessages)
        MTS_ParseMIDIDataU(client.get(), equalTemperament.data(),
                           static_cast<int>(equalTemperament.size()));
    tunedByMessages = false;
    forgetsMessages = false;
}

void Tuner::tune(Player* player) noexcept {
    followForgetting();
    if (const auto* given = handoff.take())
        own = *given;
    if (player == nullptr)
        return;
    if (!own)
        readSession();
    player->setTuning(own ? *own : session);
}

/// Ignores a pitch that is not finite or farther away than any key.
void Tuner::readSession() noexcept {
    session = {};
    if (!tunedByMessages && !MTS_HasMaster(client.get()))
        return;
    for (int note = 0; note < KeyTuning::notes; ++note) {
        const auto index = static_cast<std::size_t>(note);
        const auto key = static_cast<char>(note);
        const double semitones = MTS_RetuningInSemitones(client.get(), key, anyChannel);
        if (MTS_ShouldFilterNote(client.get(), key, anyChannel) ||
            !(std::abs(semitones) <= maximumSemitones))
            session.unmapped.set(index);
        else
            session.semitonesFromEqual[index] = semitones;
    }
}

} // namespace idiophone
