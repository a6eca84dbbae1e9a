// What a sounding object works with while it works: shared by all objects of a synthesiser, so that
// it stays in the cache from one strike to the next. Only two things in it outlive a call: the
// responses to forces, which say whose they are, and the opening of the tubes, which the
// synthesiser sets.
#pragma once

#include "Synth/ForceResponse.h"
#include "Synth/ModalBank.h"
#include "Synth/TubeOpening.h"

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace idiophone {

/// M modes and G groups, padded to whole blocks, of the largest object.
struct SynthesisScratch {
    SynthesisScratch(std::size_t modes, std::size_t channels)
        : struckGains(modes), heardGains(modes), modeResidues(modes) {
        const std::size_t padded = (modes + modeBlock - 1) / modeBlock * modeBlock;
        for (std::size_t c = 0; c < channels; ++c) {
            for (auto* array : {&kicks.x[c], &kicks.y[c]})
                array->resize(padded);
            for (auto* residues : {&groupResidues[c], &startResidues[c], &endResidues[c]})
                residues->resize(padded);
        }
        for (auto* array :
             {&contact.x, &contact.y, &contact.steady, &contact.swingRe, &contact.swingIm,
              &contact.quadratureRe, &contact.quadratureIm, &kicks.energies})
            array->resize(padded);
        nearResidues.resize(padded);
        aboveTau.resize(padded / modeBlock);
        wanted.resize(padded / modeBlock);
        for (ForceResponses& contactResponses : responses)
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
        for (std::size_t c = 0; c < channels; ++c)
            for (auto* array : {&states.x[c], &states.y[c]})
                array->resize(padded);
    }

    std::vector<float> struckGains;                ///< [M] φ·J
    std::vector<float> heardGains;                 ///< [M] φ·ℓ
    std::vector<std::complex<float>> modeResidues; ///< [M]
    ModeResidues groupResidues;                    ///< [G]
    ChannelResidues nearResidues;                  ///< [G]
    UnitContact contact;                           ///< [G]
    ModeKicks kicks;                               ///< [G] that are not kept
    ModeResidues startResidues;                    ///< [G] where a force is at the start of a cell
    ModeResidues endResidues;                      ///< [G] where at the end
    std::array<ForceResponses, forceCapacity> responses;
    std::uint64_t responseUses = 0;      ///< so far
    std::vector<std::uint16_t> aboveTau; ///< per block: modes above τ
    std::vector<std::uint16_t> wanted;   ///< per block: modes to mix
    std::vector<std::int32_t> candidates;
    std::vector<std::int32_t> joining;
    std::vector<std::int32_t> leaving;
    std::vector<ModeRun> joiningRuns;

    TubeOpening tubes;               ///< of the cell begun last
    float tubesNow = 1;              ///< its gain at the grid point where states stand
    std::vector<ModePart> tubeParts; ///< of the modes at hand, what tubes add
    alignas(64) CellSound tubeSound; ///< what they sound

    // Where groups change.
    std::vector<std::uint8_t> silencedGroups; ///< [G]
    std::vector<std::int32_t> groupStarts;    ///< [G+1] of the groups to come
    std::vector<ModeShare> groupShares;       ///< what they take over
    std::vector<float> fadingShares;          ///< [G] of the groups that were
    ModeStates states;                        ///< [G]
};

} // namespace idiophone
