#include "Plugin/Tuner.h"

#include "Instrument/Player.h"

#include <cmath>
#include <libMTSClient.h>

namespace idiophone {
namespace {

constexpr char anyChannel = -1;
constexpr double maximumSemitones = 128;

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
    if (messages.read(message))
        tunedByMessages = true;
}

void Tuner::followForgetting() noexcept {
    if (!forgetsMessages)
        return;
    messages.reset();
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
    session = messages.keys();
    if (!MTS_HasMaster(client.get()))
        return;
    session = {};
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
