// SPDX-License-Identifier: Apache-2.0
// Working memory that all resonators of a synthesiser share, so that it stays in the cache from one
// strike to the next. Only two parts outlive a call: the responses to forces, which name their
// owner, and the opening of the tubes, which the synthesiser sets.
#pragma once

#include "Synth/ForceResponse.h"
#include "Synth/ModalBank.h"
#include "Synth/ModeFader.h"
#include "Synth/TubeOpening.h"

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace idiophone {

/// Sized for M modes and G groups, padded to whole blocks, of the largest object.
struct SynthesisScratch {
    static std::size_t paddedTo(std::size_t modes) noexcept {
        return (modes + modeBlock - 1) / modeBlock * modeBlock;
    }

    SynthesisScratch(std::size_t modes, std::size_t channels)
        : struckGains(modes), listeningGains(modes), modeResidues(modes), contact(paddedTo(modes)),
          increments(paddedTo(modes), channels), states(paddedTo(modes), channels),
          fades(paddedTo(modes), channels) {
        const std::size_t padded = paddedTo(modes);
        for (std::size_t c = 0; c < channels; ++c)
            for (auto* residues : {&groupResidues[c], &startResidues[c], &endResidues[c]})
                residues->resize(padded);
        nearResidues.resize(padded);
        energiesAfter.resize(padded);
        aboveTau.resize(padded / modeBlock);
        wanted.resize(padded / modeBlock);
        for (CachedResponses& contactResponses : responses)
            for (ForceResponse& response : contactResponses)
                for (std::size_t c = 0; c < channels; ++c)
                    response.residues[c].resize(padded);
        for (auto* list : {&candidates, &joining, &leaving})
            list->reserve(modes);
        joiningRuns.reserve(modes);
        tubeParts.reserve(modes);
        groupStarts.resize(modes + 1);
        groupShares.reserve(2 * modes);
        fadingShares.resize(modes);
        silencedGroups.resize(modes);
    }

    std::vector<float> struckGains;                ///< [M] φ·J
    std::vector<float> listeningGains;             ///< [M] φ·ℓ
    std::vector<std::complex<float>> modeResidues; ///< [M]
    ModeResidues groupResidues;                    ///< [G]
    ChannelResidues nearResidues;                  ///< [G]
    UnitContact contact;                           ///< [G]
    std::vector<float> energiesAfter;              ///< [G] of a contact's increments
    StateIncrements increments;                    ///< [G] increments that are not kept
    ModeResidues startResidues; ///< [G] at a force's place at the start of a cell
    ModeResidues endResidues;   ///< [G] at the force's place at the end of the cell
    std::array<CachedResponses, forceCapacity> responses;
    std::uint64_t responseUses = 0;      ///< counter for ForceResponse::lastUse
    std::vector<std::uint16_t> aboveTau; ///< per block: modes above τ
    std::vector<std::uint16_t> wanted;   ///< per block: modes to mix
    std::vector<std::int32_t> candidates;
    std::vector<std::int32_t> joining;
    std::vector<std::int32_t> leaving;
    std::vector<ModeRun> joiningRuns;

    TubeOpening tubes;               ///< of the current cell
    float tubesNow = 1;              ///< gain of the tubes at the grid point where states hold
    std::vector<ModePart> tubeParts; ///< tube parts of the current modes
    alignas(64) CellSound tubeSound; ///< sound of `tubeParts`

    // Scratch for changes of groups.
    std::int64_t modesToRegroup = 0;          ///< how many strikes may still regroup in this cell
    std::vector<std::uint8_t> silencedGroups; ///< [G]
    std::vector<std::int32_t> groupStarts;    ///< [G+1] of the new groups
    std::vector<ModeShare> groupShares;       ///< shares that the new groups take over
    std::vector<float> fadingShares;          ///< [G] of the old groups
    ModeStates states;                        ///< [G]
    FadeRoom fades;
};

} // namespace idiophone
