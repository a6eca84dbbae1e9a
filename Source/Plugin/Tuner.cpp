#include "Plugin/Tuner.h"

#include "Instrument/Player.h"

#include <array>
#include <cmath>
#include <libMTSClient.h>

namespace idiophone {
namespace {

constexpr char anyChannel = -1;
constexpr double farthestSemitones = 128;

/// Scale of an octave, one byte a note, on all channels.
constexpr std::array<juce::uint8, 21> equalTemperament{0xf0, 0x7e, 0x7f, 0x08, 0x08, 0x03, 0x7f,
                                                       0x7f, 64,   64,   64,   64,   64,   64,
                                                       64,   64,   64,   64,   64,   64,   0xf7};

} // namespace

void Tuner::Deregister::operator()(MTSClient* registered) const {
    MTS_DeregisterClient(registered);
}

Tuner::Tuner() : client(MTS_RegisterClient()) {}

void Tuner::setOwn(const std::optional<KeyTuning>& tuning) noexcept {
    handoff.next() = {.isGiven = tuning.has_value(), .keys = tuning.value_or(KeyTuning{})};
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
    // F0, any or real time, any device, MIDI Tuning Standard.
    const bool isTuning =
        message.size() > 4 && (message[1] == 0x7e || message[1] == 0x7f) && message[3] == 0x08;
    if (!isTuning)
        return;
    MTS_ParseMIDIDataU(client.get(), message.data(), static_cast<int>(message.size()));
    tunedByMessages = true;
}

/// The client has no way to forget but a message: no offset for any of the twelve notes.
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
    if (!own.isGiven)
        readSession();
    player->setTuning(own.isGiven ? own.keys : session);
}

/// A pitch that is no number, or as far away as no key is, is none.
void Tuner::readSession() noexcept {
    session = {};
    if (!tunedByMessages && !MTS_HasMaster(client.get()))
        return;
    for (int note = 0; note < KeyTuning::notes; ++note) {
        const auto index = static_cast<std::size_t>(note);
        const auto key = static_cast<char>(note);
        const double semitones = MTS_RetuningInSemitones(client.get(), key, anyChannel);
        if (MTS_ShouldFilterNote(client.get(), key, anyChannel) ||
            !(std::abs(semitones) <= farthestSemitones))
            session.unmapped.set(index);
        else
            session.semitonesFromEqual[index] = semitones;
    }
}

} // namespace idiophone
