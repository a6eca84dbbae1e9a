// SPDX-License-Identifier: Apache-2.0
// The groups of an object's modes that are heard as one (docs/decisions/0015). They follow the
// poles, which live material, thickness, imperfection and compression move.
#pragma once

#include "Synth/Imperfection.h"
#include "Synth/LiveConditions.h"
#include "Synth/ModalPole.h"
#include "Synth/ModeResidues.h"
#include "Synth/SynthesisScratch.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace idiophone {

/// The values that the groups of an object depend on.
struct GroupConditions {
    PoleLaw law;
    double compression = 1;
    double thicknessRatio = 1; ///< 1 if the object has no live thickness
    double imperfection = 0;

    bool operator==(const GroupConditions&) const = default;
};

/// Memory is reserved by the constructor; every other member is for the audio thread. M modes form
/// G groups; group g is the modes starts()[g] to starts()[g+1] − 1.
class ModeGroups {
public:
    using ModeWeights = std::shared_ptr<const std::vector<double>>;

    /// Each mode begins as a group of its own. `weights` [M] are the object's `summedSquareShapes`.
    /// `seed` draws the imperfection. Object and scratch must outlive this object.
    ModeGroups(const ModalObject& object,
               ModeWeights weights,
               std::uint32_t seed,
               double sampleRateHz,
               SynthesisScratch& scratch);

    std::size_t size() const noexcept { return count; }
    std::span<const std::int32_t> starts() const noexcept {
        return std::span(groupStarts).first(count + 1);
    }
    std::span<const double> eigenvalues() const noexcept {
        return std::span(groupEigenvalues).first(count);
    }
    /// [G], or empty: the law's.
    std::span<const ModeDamping> dampings() const noexcept { return groupDampings; }
    std::span<const ModePair> pairs() const noexcept { return modePairs; }

    const GroupConditions& conditions() const noexcept { return current; }
    /// Requests modes with values ≠ 0 to be silenced ([M], or empty: none). Returns whether the
    /// request changes the silenced modes.
    bool requestSilenced(std::span<const std::uint8_t> silenced) noexcept;
    /// Returns whether `set` would change anything.
    bool differFrom(const GroupConditions& wanted) const noexcept {
        return silencesChange || wanted != current;
    }
    /// Sets the conditions and the requested silences; the groups follow in `follow` or `keep`.
    void set(const GroupConditions& wanted) noexcept;
    /// Returns whether neither `follow` nor `keep` was called for the conditions.
    bool areBehind() const noexcept { return behind; }
    /// Returns whether other modes may form groups under the conditions.
    bool areOutdated() const noexcept { return outdated; }
    /// Returns whether groups cannot be kept, because only some of their modes are silenced.
    bool mustFollow() const noexcept { return mixesKinds; }
    /// Groups the modes anew. Returns whether the groups have changed. If so, `shares` tells how,
    /// until the next change.
    bool follow() noexcept;
    /// Keeps the groups and how they merge residues for the conditions, until they follow.
    void keep() noexcept;
    std::span<const ModeShare> shares() const noexcept { return scratch.groupShares; }

    bool inBand(std::size_t g) const noexcept {
        return soundsAt({.stiffness = current.law.stiffness(groupEigenvalues[g])}, rateHz);
    }
    bool silenced(std::size_t g) const noexcept {
        return !silencedModes.empty() && silencedModes[index(groupStarts[g])] != 0;
    }
    bool audible(std::size_t g) const noexcept { return inBand(g) && !silenced(g); }
    /// Returns [G], or empty if no mode is silenced; valid until the next call.
    std::span<const std::uint8_t> silences() const noexcept;

    /// Merges residues of modes [M] into those of groups.
    void merge(std::span<const std::complex<float>> modes, ChannelResidues& residues) noexcept;

private:
    void findShares(std::size_t groups) noexcept;
    void moveModes() noexcept;
    void computeValues() noexcept;
    void findLostShares() noexcept;
    /// Returns the values of a group's modes, or nothing if there are no values.
    template <class Value>
    std::span<const Value> ofGroup(std::size_t g, std::span<const Value> ofModes) const noexcept {
        const std::size_t first = index(groupStarts[g]);
        return ofModes.empty() ? ofModes
                               : ofModes.subspan(first, index(groupStarts[g + 1]) - first);
    }

    const ModalObject& object;
    SynthesisScratch& scratch;
    double rateHz;
    GroupConditions current;
    bool behind = true, outdated = true, mixesKinds = false;
    bool eigenvaluesAreBehind = false; ///< not yet computed for a new thickness or imperfection
    std::vector<std::uint8_t> requestedSilences, silencedModes; ///< [M], or empty: none
    bool silencesChange = false;
    ModeWeights modeWeights;
    std::size_t count;                      ///< G
    std::vector<std::int32_t> groupStarts;  ///< [M+1]
    std::vector<std::int32_t> mergedGroups; ///< those of several modes, ascending
    std::vector<double> modeEigenvalues;    ///< [M] reference eigenvalues at the live thickness
    std::vector<double> groupEigenvalues;   ///< [M], of which G are used
    std::vector<ModePair> modePairs;        ///< of equal modes
    std::vector<ModeDamping> modeDampings;  ///< [M], or empty: the law's
    std::vector<ModeDamping> groupDampings; ///< [M], of which G are used
    PoleLaw groupedLaw;                     ///< of the last `follow`
    std::vector<float> lostShares;          ///< of the pairs in every group (ModeCompression.h)
    std::optional<PoleLaw> lostSharesLaw;   ///< law that `lostShares` belong to
};

} // namespace idiophone
