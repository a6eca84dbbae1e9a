// Applies the settings to a resonator: poles, damping and truncation.
#include "Synth/Listening.h"
#include "Synth/LiveConditions.h"
#include "Synth/ModalResonator.h"
#include "Synth/ModeCompression.h"

#include <algorithm>
#include <cmath>

namespace idiophone {

void ModalResonator::applySettings(const SynthesisSettings& settings) noexcept {
    controlsChanged = false;
    SynthesisSettings own = settings;
    if (requestedMaterial)
        own.material = requestedMaterial;
    const LiveConditions live = liveConditions(object->material, own, slotSizeRatio,
                                               requestedFrequencyRatio, pitch ? &*pitch : nullptr);
    const double thickness = object->hasLiveThickness() ? settings.thicknessRatio : 1;
    // Even τ = 0 drops states below an inaudible floor.
    const double newTau = std::max(settings.tau * pascalsPerTau, faintestVelocity);
    listening = {.nearGain = contactMicrophonePascals * live.gainRatio / thickness,
                 .farGain = live.radiationGainRatio / thickness,
                 .farShare = object->radiation.empty() ? 0 : settings.radiation};
    sizeNow = slotSizeRatio * settings.sizeRatio;

    const bool polesMove = live.law != law || settings.compression != compression ||
                           thickness != thicknessRatio || silencesChange ||
                           settings.imperfection != imperfection;
    const bool dampingMoves = requestedDamping != damping;
    const bool weightsMove = live.radiationRatio != wantedRadiationRatio;
    const bool contactsMove = polesMove || dampingMoves || weightsMove;
    const bool tauFalls = newTau < tauPascals;
    if (!contactsMove && newTau == tauPascals)
        return;
    // A contact's forced part belongs to the poles, radiation weights and damping that it was
    // computed with. Turn it into free motion before the change, and take it out again with the new
    // values.
    if (contactsMove)
        moveContacts(Forced::freed);
    wantedRadiationRatio = live.radiationRatio;
    ++responseVersion;
    dampingLogBase = dampingLog(cellIndex);
    dampingSince = cellIndex;
    damping = requestedDamping;
    tauPascals = newTau;
    law = live.law;
    eigenvaluesAreBehind = eigenvaluesAreBehind || thickness != thicknessRatio ||
                           settings.imperfection != imperfection;
    thicknessRatio = thickness;
    if ((settings.imperfection > 0) != (imperfection > 0))
        radiationRatio = 0; // the weights must be read again, with or without rotated pairs
    imperfection = settings.imperfection;
    compression = settings.compression;
    if (silencesChange)
        takeSilences();
    polesBehind = polesBehind || polesMove;
    if (polesBehind && (ringing() || holdsAboveTau()))
        movePoles();
    if (contactsMove)
        moveContacts(Forced::held);
    if (polesMove || tauFalls)
        wakeBlocks();
}

void ModalResonator::catchUp(const SynthesisSettings& settings) noexcept {
    if (!controlsChanged || !contacts.empty())
        return;
    takeInIncrements(cellIndex + 1);
    ++cellIndex; // the states hold there
    applySettings(settings);
    --cellIndex;
}

/// The groups follow in movePoles.
void ModalResonator::takeSilences() noexcept {
    silencesChange = false;
    silencedModes.assign(requestedSilences.begin(), requestedSilences.end());
}

void ModalResonator::movePoles() noexcept {
    polesBehind = false;
    ++responseVersion;
    // Bring resting states up to date with their old poles.
    bringRestingUpToDate(cellIndex);
    if (eigenvaluesAreBehind) {
        for (std::size_t mode = 0; mode < modeEigenvalues.size(); ++mode)
            modeEigenvalues[mode] = object->eigenvalueAt(mode, thicknessRatio);
        partPairs(pairs, imperfection, modeEigenvalues);
    }
    const std::size_t groups = groupModes(modeEigenvalues, law, compression, scratch.groupStarts,
                                          dampings, silencedModes, object->gains);
    if (groups == bank.size() &&
        std::equal(groupStarts.begin(), groupStarts.begin() + static_cast<std::ptrdiff_t>(groups),
                   scratch.groupStarts.begin())) {
        if (eigenvaluesAreBehind)
            nameGroups(groups);
        fadeInaudible();
    } else {
        regroup(groups);
    }
    eigenvaluesAreBehind = false;
    std::span<std::uint8_t> silencedGroups;
    if (!silencedModes.empty()) {
        silencedGroups = std::span(scratch.silencedGroups).first(bank.size());
        for (std::size_t g = 0; g < bank.size(); ++g)
            silencedGroups[g] = silenced(g) ? 1 : 0;
    }
    bank.movePoles(std::span(referenceEigenvalues).first(bank.size()), law, lowestSoundingHz,
                   highestSoundingShare * sampleRate, groupDampings, silencedGroups);
}

bool ModalResonator::inBand(std::size_t g) const noexcept {
    return soundsAt(law.pole(referenceEigenvalues[g]), sampleRate);
}

/// Modes that τ had cut or that were out of band may become audible with other poles.
bool ModalResonator::holdsAboveTau() const noexcept {
    for (std::size_t b = 0; b < bank.blockCount(); ++b)
        if (bank.energyOfLoudest(b) > tauEnergy())
            return true;
    return false;
}

/// Fades out newly inaudible modes, still with their old poles: beyond the band the new ones would
/// alias.
void ModalResonator::fadeInaudible() noexcept {
    scratch.leaving.clear();
    for (const std::int32_t g : mixedModes) {
        const auto mode = static_cast<std::size_t>(g);
        if (audible(mode))
            continue;
        scratch.leaving.push_back(g);
        Block& block = blocks[mode / modeBlock];
        const unsigned others = ~(1u << (mode % modeBlock));
        block.mixed = static_cast<std::uint16_t>(block.mixed & others);
        block.rings = static_cast<std::uint16_t>(block.rings & others);
    }
    if (scratch.leaving.empty())
        return;
    fade(scratch.leaving, 1);
    listMixed();
    retireBlocks(cellIndex);
}

double ModalResonator::dampingLog(std::int64_t grid) const noexcept {
    return dampingLogBase + damping * cellSeconds * static_cast<double>(grid - dampingSince);
}

} // namespace idiophone
