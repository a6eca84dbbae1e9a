#include "Instrument/PitchBend.h"

#include "Instrument/MidiControllers.h"

#include <algorithm>
#include <utility>

namespace idiophone {
namespace {

constexpr int lowerManager = 0, upperManager = 15;
constexpr int maximumMembers = 15;
constexpr double memberSemitones = 48; // initial range of a configured zone

enum RegisteredParameter { bendSensitivity = 0, mpeConfiguration = 6 };

std::size_t at(int index) noexcept {
    return static_cast<std::size_t>(index);
}

} // namespace

void PitchBend::setParameters(const ParameterValues& parameters) noexcept {
    commonRange.setParameter(parameters[ParameterId::bendRange]);
    memberRange.setParameter(parameters[ParameterId::mpeBendRange]);
    const bool isOn = parameters[ParameterId::mpe] != 0;
    const bool isMoved = std::exchange(mpeParameter, isOn) != isOn;
    if (isMoved && !(configured && configured->any() == isOn)) {
        configured.reset();
        reset();
    }
    bendHeldNotes();
}

void PitchBend::forgetGiven() noexcept {
    commonRange.forgetGiven();
    memberRange.forgetGiven();
    newlyGiven = {};
    if (std::exchange(configured, std::nullopt))
        reset();
    bendHeldNotes();
}

PitchBend::Zones PitchBend::zones() const noexcept {
    return configured.value_or(Zones{.lowerMembers = mpeParameter ? maximumMembers : 0});
}

bool PitchBend::isMember(int channel) const noexcept {
    const auto [lower, upper] = zones();
    return (channel > lowerManager && channel <= lower) ||
           (channel < upperManager && channel >= upperManager - upper);
}

PitchBend::Group PitchBend::groupOf(int channel) const noexcept {
    const auto [lower, upper] = zones();
    if (lower > 0 && channel <= lower)
        return lowerZone;
    return upper > 0 && channel >= upperManager - upper ? upperZone : outside;
}

PitchBend::Channels PitchBend::reachOf(int channel) const noexcept {
    const auto [lower, upper] = zones();
    if (channel == lowerManager && lower > 0)
        return {lowerManager, lower};
    if (channel == upperManager && upper > 0)
        return {upperManager - upper, upperManager};
    return {channel, channel};
}

void PitchBend::noteOn(int channel, int note) noexcept {
    heldBy[at(note)] = isMember(channel) ? static_cast<std::int8_t>(channel) : none;
    noteGroups[at(note)] = groupOf(channel);
    noteSemitones[at(note)] = 0;
    bendHeldNotes();
}

void PitchBend::noteOff(int channel, int note) noexcept {
    if (heldBy[at(note)] == channel)
        heldBy[at(note)] = none;
}

void PitchBend::wheel(int channel, int low, int high) noexcept {
    const double bend = std::clamp((high * 128 + low - 8192) / 8191.0, -1.0, 1.0);
    if (!isMember(channel)) {
        commonBends[groupOf(channel)] = bend;
        return;
    }
    memberBends[at(channel)] = bend;
    bendHeldNotes();
}

void PitchBend::bendHeldNotes() noexcept {
    for (std::size_t note = 0; note < heldBy.size(); ++note)
        if (heldBy[note] != none)
            noteSemitones[note] = memberBends[at(heldBy[note])] * memberRange.semitones();
}

void PitchBend::controller(int channel, int number, int value) noexcept {
    const auto small = static_cast<std::int8_t>(value);
    const bool isSensitivity =
        parameterMsb[at(channel)] == 0 && parameterLsb[at(channel)] == bendSensitivity;
    const bool isConfiguration =
        parameterMsb[at(channel)] == 0 && parameterLsb[at(channel)] == mpeConfiguration;
    switch (number) {
    case midi::registeredMsb:
        parameterMsb[at(channel)] = small;
        break;
    case midi::registeredLsb:
        parameterLsb[at(channel)] = small;
        break;
    case midi::unregisteredLsb:
    case midi::unregisteredMsb:
        forgetParameter(channel);
        break;
    case midi::dataEntryMsb:
        if (isSensitivity)
            giveRange(channel, value, 0);
        else if (isConfiguration)
            configure(channel, value);
        break;
    case midi::dataEntryLsb:
        if (isSensitivity)
            giveRange(channel, static_cast<int>(rangeOf(channel).semitones()), value);
        break;
    case midi::resetControllers:
        if (!isMember(channel))
            commonBends[groupOf(channel)] = 0;
        for (int each = reachOf(channel).first; each <= reachOf(channel).last; ++each) {
            memberBends[at(each)] = 0;
            forgetParameter(each);
        }
        bendHeldNotes();
        break;
    default:
        break;
    }
}

void PitchBend::giveRange(int channel, int semitones, int cents) noexcept {
    const double given = semitones + std::min(cents, 99) / 100.0;
    rangeOf(channel).give(given);
    if (isMember(channel))
        newlyGiven.memberRange = given;
    bendHeldNotes();
}

/// A zone takes the channels that it asks for from the other zone. Zero members end the zone.
void PitchBend::configure(int managerChannel, int members) noexcept {
    if (managerChannel != lowerManager && managerChannel != upperManager)
        return;
    auto wanted = zones();
    auto& own = managerChannel == lowerManager ? wanted.lowerMembers : wanted.upperMembers;
    auto& other = managerChannel == lowerManager ? wanted.upperMembers : wanted.lowerMembers;
    own = std::clamp(members, 0, maximumMembers);
    // Fourteen members and two managers use all channels.
    if (own > 0)
        other = std::clamp(other, 0, std::max(maximumMembers - 1 - own, 0));
    configured = wanted;
    newlyGiven.mpe = wanted.any() ? 1 : 0;
    if (own > 0) {
        memberRange.give(memberSemitones);
        newlyGiven.memberRange = memberSemitones;
    }
    reset();
}

void PitchBend::forgetParameter(int channel) noexcept {
    parameterMsb[at(channel)] = parameterLsb[at(channel)] = nullParameter;
}

void PitchBend::releaseNotes() noexcept {
    heldBy.fill(none);
}

void PitchBend::reset() noexcept {
    commonBends.fill(0);
    heldBy.fill(none);
    noteSemitones.fill(0);
    noteGroups.fill(groupOf(lowerManager));
    memberBends.fill(0);
}

double PitchBend::commonSemitones(int note) const noexcept {
    const auto group = note < 0 ? groupOf(lowerManager) : noteGroups[at(note)];
    return commonBends[group] * commonRange.semitones();
}

void PitchBend::takeWheelsOf(const PitchBend& other) noexcept {
    commonBends = other.commonBends;
    memberBends = other.memberBends;
}

void PitchBend::takeSetupOf(const PitchBend& other) noexcept {
    mpeParameter = other.mpeParameter;
    configured = other.configured;
    commonRange = other.commonRange;
    memberRange = other.memberRange;
    parameterMsb = other.parameterMsb;
    parameterLsb = other.parameterLsb;
    noteGroups.fill(groupOf(lowerManager));
}

} // namespace idiophone
