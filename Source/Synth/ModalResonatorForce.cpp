// Continuous contact of a resonator (docs/decisions/0006): output += force ∗ local impulse
// response. The states take in the effect of the force by the next grid point.
#include "Synth/AllFinite.h"
#include "Synth/ForceKernel.h"
#include "Synth/ModalResonator.h"

#include <algorithm>
#include <cmath>

namespace idiophone {

namespace {

/// Returns the immediate sound of an impulse in each channel, to be added to the motion of the
/// modes in `runs`. Together with half of the motion's first sample it makes a constant force
/// silent, as velocity and acceleration are then 0. About Σ Im r/(ω × sample time).
// Σ' ρ^k b over k ≥ 0, the first term halved, is b (1 + ρ)/(2 (1 − ρ)) with b = 1 + iα/ω.
std::array<float, maximumChannels> directSound(const ModalBank& bank,
                                               const ModeResidues& residues,
                                               std::span<const ModeRun> runs) noexcept {
    const PoleArrays& poles = bank.poles().arrays();
    std::array<float, maximumChannels> sums{};
    for (const ModeRun& run : runs) {
        const auto first = static_cast<std::size_t>(run.first);
        const std::size_t end = first + static_cast<std::size_t>(run.count);
        for (std::size_t g = first; g < end; ++g) {
            const float re = 1 - poles.sampleRe[g], im = -poles.sampleIm[g];
            const float perNorm = 0.5f / (re * re + im * im);
            const float quotientRe = ((2 - re) * re - im * im) * perNorm;
            const float quotientIm = -2 * im * perNorm;
            const auto share = static_cast<float>(poles.velocityShare[g]);
            const float restRe = quotientRe - share * quotientIm;
            const float restIm = quotientIm + share * quotientRe;
            for (std::size_t c = 0; c < bank.channels(); ++c)
                sums[c] -= residues[c].re[g] * restRe - residues[c].im[g] * restIm;
        }
    }
    // Heavy modes have rotations of 0 in the loop above. Let their whole first sample sound.
    for (const ModeRun& run : runs) {
        const auto first = static_cast<std::size_t>(run.first);
        for (const HeavyMode& heavy :
             bank.poles().heavy().in(first, first + static_cast<std::size_t>(run.count)))
            for (std::size_t c = 0; c < bank.channels(); ++c)
                sums[c] += residues[c].re[heavy.mode];
    }
    return sums;
}

} // namespace

bool ModalResonator::valid(const ForcePlace& place) const noexcept {
    const auto makesSense = [&](const ForcePoint& at) {
        return valid(at.point) && allFinite(at.direction);
    };
    return std::isfinite(place.fraction) && makesSense(place.points[0]) &&
           (place.fraction == 0 || makesSense(place.points[1]));
}

bool ModalResonator::applyForce(const ForceCell& force,
                                std::int32_t allowance,
                                const CellOutput& cell) noexcept {
    const bool stays = force.start == force.end;
    if (force.contact >= forceCapacity || !valid(force.start) || (!stays && !valid(force.end)) ||
        !allWithin(force.newtons, largestForceNewtons))
        return false;
    takeInIncrements(cellIndex + 1);
    prepareBank();
    // Interpolate a change of the listening over the cell: its step would sound like a step of the
    // force.
    if (forcedCell != cellIndex) {
        listeningAtStart = forcedCell + 1 == cellIndex ? listeningAtEnd : listening;
        listeningAtEnd = listening;
    }
    forcedCell = cellIndex;
    widen(std::max(listeningAtStart.farShare, listeningAtEnd.farShare));
    admitForced(allowance);

    alignas(64) std::array<float, cellSamples> impulses;
    const auto secondsPerSample = static_cast<float>(1 / sampleRate);
    for (std::size_t k = 0; k < cellSamples; ++k)
        impulses[k] = force.newtons[k] * secondsPerSample;
    ForceResponses& known = scratch.responses[force.contact];
    Answer start, end;
    const bool changes = !stays || listeningAtStart != listeningAtEnd;
    answerAt(force.start, listeningAtStart, known, scratch.startResidues, start);
    if (changes)
        answerAt(force.end, listeningAtEnd, known, scratch.endResidues, end);
    soundForce(impulses, start, changes ? end : start, cell);
    bringRestingUpToDate(cellIndex + 1);
    bank.force(impulses, scratch.startResidues,
               changes ? scratch.endResidues : scratch.startResidues, damping);
    if (!allMixed())
        listWhatRings();
    return true;
}

void ModalResonator::admitForced(std::int32_t allowance) noexcept {
    if (allMixed())
        return;
    for (std::size_t b = 0; b < bank.blockCount(); ++b) {
        unsigned audible = 0;
        for (std::size_t k = 0; k < modeBlock; ++k)
            audible |= (bank.poles().audible(b * modeBlock + k) ? 1u : 0u) << k;
        scratch.wanted[b] = static_cast<std::uint16_t>(audible);
    }
    std::copy_n(bank.energies(), bank.paddedSize(), increments.energies.begin());
    admitWanted(allowance);
}

/// Computes the object's response between the two points by linear interpolation.
void ModalResonator::answerAt(const ForcePlace& place,
                              const Listening& heard,
                              ForceResponses& known,
                              ModeResidues& residues,
                              Answer& answer) noexcept {
    const ForceResponse& first = responseAt(place.points[0], heard, known);
    if (place.fraction == 0) {
        for (std::size_t c = 0; c < bank.channels(); ++c)
            residues[c].copyFrom(first.residues[c], bank.paddedSize());
        answer.sound = first.sound;
        if (tubesPulse())
            answer.tube = first.tube;
        return;
    }
    const ForceResponse& second = responseAt(place.points[1], heard, known);
    for (std::size_t c = 0; c < bank.channels(); ++c) {
        blendResponses(first.residues[c].re.data(), second.residues[c].re.data(), place.fraction,
                       bank.paddedSize(), residues[c].re.data());
        blendResponses(first.residues[c].im.data(), second.residues[c].im.data(), place.fraction,
                       bank.paddedSize(), residues[c].im.data());
        blendResponses(first.sound[c].data(), second.sound[c].data(), place.fraction, cellSamples,
                       answer.sound[c].data());
        if (tubesPulse())
            blendResponses(first.tube[c].data(), second.tube[c].data(), place.fraction, cellSamples,
                           answer.tube[c].data());
    }
}

/// Returns the response at a point, from the cache if possible. A new one replaces the least
/// recently used of the contact's four.
const ForceResponse& ModalResonator::responseAt(const ForcePoint& at,
                                                const Listening& heard,
                                                ForceResponses& known) noexcept {
    const auto isAnswer = [&](const ForceResponse& response) {
        return response.object == this && response.version == responseVersion &&
               response.heard == heard && response.at == at &&
               (response.knowsTube || !tubesPulse());
    };
    ForceResponse* chosen = &known.front();
    for (ForceResponse& response : known) {
        if (isAnswer(response)) {
            chosen = &response;
            break;
        }
        if (response.lastUse < chosen->lastUse)
            chosen = &response;
    }
    if (!isAnswer(*chosen))
        answer(at, heard, *chosen);
    chosen->lastUse = ++scratch.responseUses;
    return *chosen;
}

void ModalResonator::answer(const ForcePoint& at,
                            const Listening& heard,
                            ForceResponse& response) noexcept {
    response.object = this;
    response.version = responseVersion;
    response.at = at;
    response.heard = heard;
    computeResidues(
        {.strike = {.point = at.point, .impulseNewtonSeconds = at.direction}, .heard = heard});
    scratch.contact.setImpulse(bank.poles());
    scratch.increments.start(bank, scratch.contact, scratch.groupResidues, {});
    for (std::size_t c = 0; c < bank.channels(); ++c)
        response.residues[c].copyFrom(scratch.groupResidues[c], bank.paddedSize());
    response.sound = response.tube = {};
    response.knowsTube = tubesPulse();
    const auto parts = pulsing();
    scratch.increments.sound(bank, mixedRuns, subBlocks, outputsOf(response.sound), parts,
                             outputsOf(response.tube));
    const auto direct = directSound(bank, scratch.groupResidues, mixedRuns);
    for (std::size_t c = 0; c < bank.channels(); ++c) {
        response.sound[c][0] = response.sound[c][0] / 2 + direct[c];
        response.tube[c][0] /= 2;
    }
    for (const ModePart& part : parts) {
        const ModeRun mode{part.mode, 1};
        const auto ofPart = directSound(bank, scratch.groupResidues, {&mode, 1});
        for (std::size_t c = 0; c < bank.channels(); ++c)
            response.tube[c][0] += part.share * ofPart[c];
    }
    if (damping > 0)
        for (CellSound* sound : {&response.sound, &response.tube})
            fadeByDamper(outputsOf(*sound), cellSamples);
}

void ModalResonator::soundForce(std::span<const float, cellSamples> impulses,
                                const Answer& start,
                                const Answer& end,
                                const CellOutput& cell) const noexcept {
    alignas(64) CellSound sound{};
    for (std::size_t c = 0; c < bank.channels(); ++c)
        convolveForce(impulses, start.sound[c], end.sound[c], sound[c]);
    addToCell(outputsOf(sound), 0, cellSamples, cell);
    if (!tubesPulse())
        return;
    sound = {};
    for (std::size_t c = 0; c < bank.channels(); ++c)
        convolveForce(impulses, start.tube[c], end.tube[c], sound[c]);
    closeTubes(sound, 0, cellSamples, cell);
}

} // namespace idiophone
