// SPDX-License-Identifier: Apache-2.0
#include "Synth/ForceResponses.h"

#include "Synth/ForceKernel.h"

#include <algorithm>
#include <array>
#include <functional>

namespace idiophone {

namespace {

/// Returns the immediate sound of an impulse in each channel, to be added to the motion of the
/// modes in `runs`. Together with half of the motion's first sample it makes a constant force
/// silent, because velocity and acceleration are then 0. About Σ Im r/(ω × sample time).
///
/// Σ' ρ^k b over k ≥ 0, the first term halved, is b (1 + ρ)/(2 (1 − ρ)) with b = 1 + iα/ω.
std::array<float, maximumChannels> directSound(const ModalBank& bank,
                                               const ModeResidues& residues,
                                               std::span<const ModeRun> runs) noexcept {
    const PoleArrays& poles = bank.poles().arrays();
    std::array<float, maximumChannels> sums{};
    for (const ModeRun& run : runs)
        for (std::size_t g = index(run.first); g < index(run.first + run.count); ++g) {
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
    // Heavy modes have rotations of 0 in the loop above. Let their whole first sample sound.
    for (const ModeRun& run : runs)
        for (const HeavyMode& heavy :
             bank.poles().heavy().in(index(run.first), index(run.first + run.count)))
            for (std::size_t c = 0; c < bank.channels(); ++c)
                sums[c] += residues[c].re[heavy.mode];
    return sums;
}

/// The impulses of a cell of force, in N s.
struct CellImpulses {
    CellImpulses(const ForceCell& force, double sampleRateHz) noexcept {
        const auto secondsPerSample = static_cast<float>(1 / sampleRateHz);
        for (std::size_t k = 0; k < cellSamples; ++k)
            samples[k] = force.newtons[k] * secondsPerSample;
    }
    alignas(64) std::array<float, cellSamples> samples;
};

} // namespace

ForceResponses::ForceResponses(ModalBank& ownBank,
                               BankOutput& ownOutput,
                               ActiveModes& activeModes,
                               GroupResidues& residuesOfGroups,
                               SynthesisScratch& sharedScratch)
    : bank(ownBank), output(ownOutput), active(activeModes), groupResidues(residuesOfGroups),
      scratch(sharedScratch) {}

// Interpolate a change of listening over the cell: its step would sound like a step of the force.
double ForceResponses::begin(std::int64_t cell, const Listening& listening) noexcept {
    if (lastCell != cell) {
        startListening = lastCell + 1 == cell ? endListening : listening;
        endListening = listening;
    }
    lastCell = cell;
    return std::max(startListening.farShare, endListening.farShare);
}

/// Also leaves the residues in the scratch.
void ForceResponses::hear(const ForceCell& force, HeardForce& heard) noexcept {
    heard.tubesPulse = output.tubesPulse();
    blend(force.start, startListening, force, scratch.startResidues, heard.start);
    if (changes(force))
        blend(force.end, endListening, force, scratch.endResidues, heard.end);
    else
        heard.end = heard.start;
    if (bank.channels() == 1) // a strike may open the second channel within the cell
        for (ForceSound* sound : {&heard.start, &heard.end}) {
            sound->sound[1] = sound->sound[0];
            sound->tube[1] = sound->tube[0];
        }
}

/// Computes the response between two points by linear interpolation.
void ForceResponses::blend(const ForcePlace& place,
                           const Listening& listening,
                           const ForceCell& force,
                           ModeResidues& residues,
                           ForceSound& response) noexcept {
    const bool pulses = output.tubesPulse();
    const ForceResponse& first = responseAt(place.points[0], listening, force);
    if (place.fraction == 0) {
        for (std::size_t c = 0; c < bank.channels(); ++c)
            residues[c].copyFrom(first.residues[c], bank.paddedSize());
        response.sound = first.sound;
        if (pulses)
            response.tube = first.tube;
        return;
    }
    const ForceResponse& second = responseAt(place.points[1], listening, force);
    const auto mix = [&](const auto& from, const auto& to, std::size_t count, auto& result) {
        blendResponses(from.data(), to.data(), place.fraction, count, result.data());
    };
    for (std::size_t c = 0; c < bank.channels(); ++c) {
        mix(first.residues[c].re, second.residues[c].re, bank.paddedSize(), residues[c].re);
        mix(first.residues[c].im, second.residues[c].im, bank.paddedSize(), residues[c].im);
        mix(first.sound[c], second.sound[c], cellSamples, response.sound[c]);
        if (pulses)
            mix(first.tube[c], second.tube[c], cellSamples, response.tube[c]);
    }
}

/// Returns the response at a point, from the cache if possible. A new one replaces the least
/// recently used of the contact's four.
const ForceResponse& ForceResponses::responseAt(const ForcePoint& at,
                                                const Listening& listening,
                                                const ForceCell& force) noexcept {
    CachedResponses& known = scratch.responses[force.contact];
    const std::uint64_t now = version + active.modes().version();
    const auto answers = [&](const ForceResponse& response) {
        return response.owner == this && response.version == now &&
               response.listening == listening && response.at == at &&
               response.isImpulses == force.isImpulses &&
               (response.knowsTube || !output.tubesPulse());
    };
    auto chosen = std::ranges::find_if(known, answers);
    if (chosen == known.end()) {
        chosen = std::ranges::min_element(known, {}, &ForceResponse::lastUse);
        compute(at, listening, force.isImpulses, *chosen);
        chosen->owner = this;
        chosen->version = now;
    }
    chosen->lastUse = ++scratch.responseUses;
    return *chosen;
}

void ForceResponses::compute(const ForcePoint& at,
                             const Listening& listening,
                             bool isImpulses,
                             ForceResponse& response) noexcept {
    response.at = at;
    response.listening = listening;
    response.isImpulses = isImpulses;
    groupResidues.compute(at.point, at.direction, listening);
    scratch.contact.setImpulse(bank.poles());
    scratch.increments.start(bank, scratch.contact, scratch.groupResidues, {});
    for (std::size_t c = 0; c < bank.channels(); ++c)
        response.residues[c].copyFrom(scratch.groupResidues[c], bank.paddedSize());
    response.sound = response.tube = {};
    response.knowsTube = output.tubesPulse();
    const auto runs = active.mixedRuns();
    const auto parts = output.pulsing(runs);
    scratch.increments.sound(bank, runs, subBlocks, outputsOf(response.sound), parts,
                             outputsOf(response.tube));
    if (!isImpulses) {
        const auto direct = directSound(bank, scratch.groupResidues, runs);
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
    }
    for (CellSound* sound : {&response.sound, &response.tube})
        output.fadeByDamper(outputsOf(*sound), cellSamples);
}

void ForceResponses::add(const HeardForce& heard,
                         const ForceCell& force,
                         std::size_t from,
                         std::size_t count,
                         const CellOutput& cell) const noexcept {
    const CellImpulses impulses(force, output.sampleRateHz());
    // Beyond `from + count` the convolution lacks later samples of the force, so it is not added.
    const auto sounding = [&](const CellSound& start, const CellSound& end) {
        alignas(64) CellSound whole{};
        for (std::size_t c = 0; c < bank.channels(); ++c) {
            convolveForce(impulses.samples, start[c], end[c], whole[c]);
            std::copy_n(whole[c].begin() + from, count, whole[c].begin());
        }
        return whole;
    };
    output.add(sounding(heard.start.sound, heard.end.sound), from, count, cell);
    if (!heard.tubesPulse)
        return;
    auto tube = sounding(heard.start.tube, heard.end.tube);
    output.closeTubes(tube, from, count, cell);
}

void ForceResponses::moveAsHeard(const ForceCell& force) noexcept {
    active.bringRestingUpToDate(lastCell + 1);
    const CellImpulses impulses(force, output.sampleRateHz());
    bank.force(impulses.samples, scratch.startResidues,
               changes(force) ? scratch.endResidues : scratch.startResidues, output.damping());
    if (!active.allMixed())
        active.listRinging();
}

void ForceResponses::findModes(const ForcePlace& place,
                               const Listening& listening,
                               std::span<const std::int32_t> starts,
                               PointModes& modes) noexcept {
    const Listening atThePlace{.nearGain = listening.nearGain / contactMicrophonePascals};
    const PointModes::Source source{this, version, atThePlace.nearGain, place};
    if (modes.source == source)
        return;
    modes.source = source;
    ChannelResidues& residues = scratch.startResidues[0];
    const ChannelResidues& computed = scratch.groupResidues[0];
    const auto compute = [&](const ForcePoint& at) {
        auto point = at.point; // hears along the force
        std::ranges::transform(at.direction, point.normal.begin(), std::negate());
        groupResidues.compute(point, at.direction, atThePlace);
    };
    compute(place.points[0]);
    residues.copyFrom(computed, bank.paddedSize());
    if (place.fraction != 0) {
        compute(place.points[1]);
        for (const auto part : {&ChannelResidues::re, &ChannelResidues::im}) {
            float* const values = (residues.*part).data();
            blendResponses(values, (computed.*part).data(), place.fraction, bank.paddedSize(),
                           values);
        }
    }
    takeStrongest(bank.poles(), starts, residues, modes);
}

void ForceResponses::reset() noexcept {
    lastCell = never;
    invalidate();
}

} // namespace idiophone
