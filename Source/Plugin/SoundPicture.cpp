#include "Plugin/SoundPicture.h"

#include "Instrument/OwnSlots.h"
#include "Instrument/SettingsOfParameters.h"
#include "Synth/LiveConditions.h"
#include "Synth/ModeCompression.h"
#include "Synth/QualityScaling.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace idiophone {
namespace {

ModeStanding standingOf(GroupStanding standing) {
    switch (standing) {
    case GroupStanding::sounding:
        return ModeStanding::sounding;
    case GroupStanding::beyondBudget:
        return ModeStanding::beyondBudget;
    case GroupStanding::outOfBand:
        return ModeStanding::outOfBand;
    case GroupStanding::silenced:
        return ModeStanding::silenced;
    case GroupStanding::belowTau:
        break;
    }
    return ModeStanding::belowTau;
}

} // namespace

void SoundPicture::show(PictureSubject next) {
    if (next == subject)
        return;
    subject = std::move(next);
    object.reset();
    const auto& instrument = *subject.instrument;
    const auto slots = instrument.slots();
    objectOfSlot = objectsOfSlots(instrument);
    noteOfSlot.assign(slots.size(), -1);
    modesOfSlot.assign(slots.size(), 0);
    isOfOneKey.assign(slots.size(), false);
    for (std::size_t slot = 0; slot < slots.size(); ++slot)
        modesOfSlot[slot] = static_cast<std::int32_t>(slots[slot].object->modeCount());
    for (int note = 127; note >= 0; --note)
        for (const Key& played : instrument.keysOf(note))
            if (played.slot >= 0) {
                const auto index = static_cast<std::size_t>(played.slot);
                isOfOneKey[index] = noteOfSlot[index] < 0;
                noteOfSlot[index] = note;
            }
}

/// Prepares the constant data of a slot's object.
void SoundPicture::prepareSlot(std::size_t slot) {
    frame.instrumentNumber = subject.instrumentNumber;
    frame.object = objectOfSlot[slot];
    frame.note = isOfOneKey[slot] ? noteOfSlot[slot] : -1;
    if (object == subject.instrument->slots()[slot].object)
        return;
    object = subject.instrument->slots()[slot].object;
    key = modeSetKey(*subject.instrument, slot);
    weights = summedSquareShapes(*object);
    isSilenced.clear();
    for (auto& silenced :
         silencedModes(*subject.instrument, subject.muted, subject.heardAlone).objects)
        if (silenced.object == object.get())
            isSilenced = std::move(silenced.isSilenced);
}

const SoundFrame& SoundPicture::of(const MonitoredSound& sound) {
    frame = {};
    prepareSlot(sound.slot);
    frame.tauPascals = sound.groups.tauPascals;
    frame.slope = sound.qualitySlope;
    frame.budgetModes = sound.modeBudget;
    frame.velocity = sound.velocity;
    frame.load = sound.load;
    frame.peakLeft = sound.peaks[0];
    frame.peakRight = sound.peaks[1];
    groupModesOf(sound);
    addModes(sound);
    addSlots(sound);
    frame.bodies = bodiesAt(std::span(sound.bodies).first(sound.bodyCount), objectOfSlot);
    return frame;
}

const SoundFrame&
SoundPicture::ofSilence(std::size_t slot, const ParameterValues& values, double rateHz) {
    const auto& played = subject.instrument->slots()[slot];
    const auto settings = synthesisSettings(values);
    MonitoredSound sound;
    sound.sampleRateHz = rateHz;
    sound.slot = slot;
    sound.groups.law = liveConditions(played, settings).law;
    sound.groups.thicknessRatio = played.object->hasLiveThickness() ? settings.thicknessRatio : 1;
    sound.groups.tauPascals = settings.tau * pascalsPerTau;
    sound.groups.compression = settings.compression;
    sound.groups.groupsAreBehind = true;
    sound.qualitySlope = settings.qualitySlope;
    sound.modeBudget = settings.modeBudget;
    of(sound);
    if (const auto& stage = subject.instrument->stage())
        frame.bodies = bodiesAt(stage->firstPoses(), objectOfSlot);
    return frame;
}

std::vector<BodyNow> bodiesAt(std::span<const BodyPose> poses, std::span<const int> objectOfSlot) {
    std::vector<BodyNow> bodies;
    for (std::size_t slot = 0; slot < std::min(poses.size(), objectOfSlot.size()); ++slot)
        if (const auto& pose = poses[slot]; pose.isThere)
            bodies.push_back({.object = objectOfSlot[slot],
                              .originMetres = pose.originMetres,
                              .turn = pose.turn});
    return bodies;
}

/// Groups the modes as the synthesis does, or will when the object is struck.
void SoundPicture::groupModesOf(const MonitoredSound& sound) {
    const SoundingGroups& groups = sound.groups;
    if (!groups.groupsAreBehind) {
        groupStarts.assign(groups.starts.begin(),
                           groups.starts.begin() + static_cast<std::ptrdiff_t>(groups.count) + 1);
        return;
    }
    std::vector<double> eigenvalues;
    for (std::size_t mode = 0; mode < object->modeCount(); ++mode)
        eigenvalues.push_back(object->eigenvalueAt(mode, groups.thicknessRatio));
    groupStarts.resize(object->modeCount() + 1);
    groupStarts.resize(groupModes(eigenvalues, groups.law, groups.compression, groupStarts,
                                  object->dampings(), isSilenced, object->gains) +
                       1);
}

void SoundPicture::addModes(const MonitoredSound& sound) {
    const auto total = object->modeCount();
    for (std::size_t g = 0; g + 1 < groupStarts.size(); ++g) {
        const auto first = static_cast<std::size_t>(groupStarts[g]);
        const auto end = std::min(static_cast<std::size_t>(groupStarts[g + 1]), total);
        if (end > MonitoredSound::maximumModes)
            break;
        const double sum = std::accumulate(weights.begin() + static_cast<std::ptrdiff_t>(first),
                                           weights.begin() + static_cast<std::ptrdiff_t>(end), 0.0);
        for (std::size_t mode = first; mode < end; ++mode) {
            ModeNow now = modeNow(sound, mode);
            now.group = static_cast<std::int32_t>(g);
            if (!sound.groups.groupsAreBehind) {
                const double share =
                    sum > 0 ? weights[mode] / sum : 1 / static_cast<double>(end - first);
                now.amplitude = static_cast<float>(share) * sound.groups.amplitudes[g];
                now.standing = standingOf(sound.groups.standings[g]);
            }
            frame.modes.push_back(now);
        }
    }
    frame.modesOmitted = static_cast<std::int32_t>(total - frame.modes.size());
}

/// Returns the entry of a silent mode.
ModeNow SoundPicture::modeNow(const MonitoredSound& sound, std::size_t mode) const {
    const ModalPole pole = sound.groups.law.pole(
        object->eigenvalueAt(mode, sound.groups.thicknessRatio), object->damping(mode));
    const auto number = static_cast<std::int32_t>(mode);
    ModeNow now;
    now.frequencyHz =
        static_cast<float>(isOscillating(pole) ? dampedFrequency(pole) / (2 * std::numbers::pi)
                                               : naturalFrequencyHz(pole));
    now.t60Seconds = static_cast<float>(std::log(1000) / decayBound(pole));
    now.isMuted = subject.muted.contains(key, number);
    now.isHeardAlone = subject.heardAlone.contains(key, number);
    if (!soundsAt(pole, sound.sampleRateHz))
        now.standing = ModeStanding::outOfBand;
    else if (!isSilenced.empty() && isSilenced[mode] != 0)
        now.standing = ModeStanding::silenced;
    return now;
}

void SoundPicture::addSlots(const MonitoredSound& sound) {
    for (std::size_t slot = 0; slot < std::min(sound.slotCount, objectOfSlot.size()); ++slot) {
        const auto& status = sound.slots[slot];
        if (status.modesRinging == 0 && status.modesMixed == 0)
            continue;
        frame.slots.push_back({.object = objectOfSlot[slot],
                               .note = noteOfSlot[slot],
                               .amplitude = status.amplitude,
                               .modesRinging = status.modesRinging,
                               .share = status.share,
                               .modesMixed = status.modesMixed,
                               .entitlement = 0});
        frame.modesMixed += status.modesMixed;
        frame.modesDropped += std::max(status.groupsAudible - status.modesRinging, 0);
        frame.modesBeyond += std::max(status.modesRinging - status.modesMixed, 0);
        frame.modesMerged += modesOfSlot[slot] - status.groups;
    }
    std::ranges::stable_sort(frame.slots, std::greater(), &SlotNow::amplitude);
    for (std::size_t rank = 0; rank < frame.slots.size(); ++rank)
        frame.slots[rank].entitlement = static_cast<float>(
            modeEntitlement(rank, frame.slots.size(), sound.modeBudget, sound.qualitySlope));
}

} // namespace idiophone
