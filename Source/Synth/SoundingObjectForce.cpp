// Continuous contact of a sounding object (DESIGN 5): output += force ∗ local impulse response, and
// the states take in what the force did to them by the next grid point.
#include "Synth/ForceKernel.h"
#include "Synth/SoundingObject.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {

bool SoundingObject::applyForce(const ForceCell& force,
                                std::int32_t allowance,
                                const CellOutput& cell) noexcept {
    const auto isFinite = [](float value) { return std::isfinite(value); };
    if (!valid(force.start) || !valid(force.end) || !std::ranges::all_of(force.newtons, isFinite) ||
        !std::ranges::all_of(force.startDirection, isFinite) ||
        !std::ranges::all_of(force.endDirection, isFinite))
        return false;
    takeInKicks(cellIndex + 1);
    prepareBank();
    widen(object->radiation.empty() ? 0 : radiation);
    forcedCell = cellIndex;
    admitForced(allowance);

    alignas(64) std::array<float, cellSamples> impulses;
    for (std::size_t k = 0; k < cellSamples; ++k)
        impulses[k] = force.newtons[k] / static_cast<float>(sampleRate);
    std::swap(responses[0], responses[1]);
    findResponse(force.start, force.startDirection, 0);
    findResponse(force.end, force.endDirection, 1);
    soundForce(impulses, cell);
    bringRestingUpToDate(cellIndex + 1);
    for (std::size_t c = 0; c < bank.channels(); ++c)
        bank.force(impulses, responses[0].residues[c].data(), responses[1].residues[c].data(),
                   damping, c);
    bank.measureAll();
    if (!allMixed())
        listWhatRings();
    return true;
}

void SoundingObject::admitForced(std::int32_t allowance) noexcept {
    if (allMixed())
        return;
    for (std::size_t b = 0; b < bank.blockCount(); ++b) {
        unsigned audible = 0;
        for (std::size_t k = 0; k < modeBlock; ++k)
            audible |= (bank.audible(b * modeBlock + k) ? 1u : 0u) << k;
        scratch.wanted[b] = static_cast<std::uint16_t>(audible);
    }
    std::copy_n(bank.energies(), bank.paddedSize(), kicks.energies.begin());
    admitWanted(allowance);
}

/// Response 0 or 1 becomes that of a place, from the other one where that has it.
void SoundingObject::findResponse(const StrikePoint& point,
                                  const std::array<float, 3>& direction,
                                  std::size_t which) noexcept {
    const auto isThere = [&](const Response& response) {
        return response.version == responseVersion && response.point == point &&
               response.direction == direction;
    };
    Response& response = responses[which];
    const Response& other = responses[1 - which];
    if (isThere(response))
        return;
    response.point = point;
    response.direction = direction;
    response.version = responseVersion;
    if (isThere(other)) {
        for (std::size_t c = 0; c < bank.channels(); ++c)
            std::copy(other.residues[c].begin(), other.residues[c].end(),
                      response.residues[c].begin());
        response.sound = other.sound;
        return;
    }
    computeResidues({.strike = {.point = point, .impulseNewtonSeconds = direction},
                     .gainRatio = gainRatio,
                     .listening = object->radiation.empty() ? 0 : radiation});
    bank.impulseStates(scratch.contact);
    bank.startKicks(scratch.contact, scratch.groupResidues, {}, scratch.kicks);
    for (std::size_t c = 0; c < bank.channels(); ++c)
        std::copy_n(scratch.groupResidues[c].begin(), bank.paddedSize(),
                    response.residues[c].begin());
    response.sound = {};
    bank.sound(scratch.kicks, mixedRuns, subBlocks,
               {response.sound[0].data(), response.sound[1].data()});
    const double fall = std::exp(-damping / sampleRate);
    double factor = 1;
    for (std::size_t k = 0; k < cellSamples; ++k) {
        for (auto& sound : response.sound)
            sound[k] *= static_cast<float>(factor);
        factor *= fall;
    }
}

void SoundingObject::soundForce(std::span<const float, cellSamples> impulses,
                                const CellOutput& cell) const noexcept {
    alignas(64) std::array<std::array<float, cellSamples>, mostChannels> sound{};
    for (std::size_t c = 0; c < bank.channels(); ++c) {
        float* output = sound[c].data();
        for (std::size_t b = 0; b < subBlocks; ++b) {
            alignas(64) std::array<float, cellSamples> response;
            for (std::size_t k = 0; k < cellSamples; ++k)
                response[k] = responses[0].sound[c][k] +
                              shareOfWay(b) * (responses[1].sound[c][k] - responses[0].sound[c][k]);
            for (std::size_t k = b * subBlockSamples; k < (b + 1) * subBlockSamples; ++k)
                for (std::size_t n = k; n < cellSamples; ++n)
                    output[n] += impulses[k] * response[n - k];
        }
    }
    addToCell({sound[0].data(), sound[1].data()}, 0, cellSamples, cell);
}

} // namespace idiophone
