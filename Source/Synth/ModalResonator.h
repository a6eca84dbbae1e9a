// A resonator, one slot of the synthesiser: the groups of modes of an object, their states, and the
// sets of ringing and mixed modes. It renders cells and takes strikes; the budget comes from the
// synthesiser.
#pragma once

#include "Synth/AccelerationNoise.h"
#include "Synth/CellOutput.h"
#include "Synth/ForceCell.h"
#include "Synth/Imperfection.h"
#include "Synth/IncrementKernel.h"
#include "Synth/ModalBank.h"
#include "Synth/ModeFader.h"
#include "Synth/QualityScaling.h"
#include "Synth/SoundingGroups.h"
#include "Synth/Strike.h"
#include "Synth/StrikeKernel.h"
#include "Synth/SynthesisScratch.h"
#include "Synth/SynthesisSettings.h"
#include "Synth/SynthesiserSlot.h"

#include <array>
#include <bit>
#include <complex>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace idiophone {

/// Memory is reserved by the constructor; every other member is for the audio thread. The current
/// cell is the one begun last. States of active blocks hold at its start; after `mix` they hold at
/// its end.
class ModalResonator {
public:
    static constexpr std::size_t contactCapacity = 64;

    using ModeWeights = std::shared_ptr<const std::vector<double>>;

    /// `channels` is the channel count of the cells, 1 or 2. A resonator sounds in stereo from the
    /// first far-heard strike (`SynthesisSettings::radiation`) until it is silent again.
    /// `modeWeights` [M] are the object's `summedSquareShapes`, shared by all its slots. `seed`
    /// draws its imperfection. `scratch` has room for this object and outlives it; resonators on
    /// one thread share it.
    ModalResonator(SynthesiserSlot slot,
                   ModeWeights modeWeights,
                   std::uint32_t seed,
                   std::size_t channels,
                   double sampleRateHz,
                   SynthesisScratch& scratch);

    void setDamping(double dampingPerSecond) noexcept;
    void setFrequencyRatio(double ratio) noexcept;
    double frequencyRatio() const noexcept { return requestedFrequencyRatio; }
    /// Replaces the settings' material; empty: use the settings'. Its values must be in range.
    void setMaterial(const std::optional<LiveMaterial>& material) noexcept;
    /// Mutes modes with values ≠ 0 from the next `beginCell` on ([modes of the object], or empty:
    /// none). They fade out and in, and ring on unheard in between.
    void setSilencedModes(std::span<const std::uint8_t> silenced) noexcept;

    /// Moves to the grid point of cell `index`: applies pending settings and drops modes at t_c
    /// (Raghuvanshi & Lin 2006, eq. 14). Returns whether there is anything to mix.
    bool beginCell(std::int64_t index,
                   const SynthesisSettings& settings,
                   bool settingsChanged) noexcept {
        if (keptIncrements || settingsChanged || controlsChanged || !silent())
            return beginSoundingCell(index, settings, settingsChanged);
        cellIndex = index;
        return false;
    }

    /// Returns the demand for quality scaling; call it after `beginCell`. It includes modes held by
    /// a contact.
    ModeDemand demand() const noexcept { return demanded; }

    /// Mixes the strongest `share` modes into the cell. During a contact its modes stay, whatever
    /// the share, as its forced part was summed over them.
    void mix(std::int32_t share, const CellOutput& cell) noexcept;

    /// Call it after `mix`, before a strike. Applies what was set since `beginCell`: to the strike
    /// at once, and to ringing modes from the next grid point, where their states hold. During a
    /// contact, all of it waits for the next cell.
    void catchUp(const SynthesisSettings& settings) noexcept;

    /// Adds a strike to the rest of the current cell. `allowance` bounds the number of modes mixed
    /// after it. A contact shorter than two samples is an impulse. Returns false and does nothing
    /// if no contact is free or the strike is not valid for this object.
    bool strike(const Strike& strike,
                double sampleInCell,
                std::int32_t allowance,
                const CellOutput& cell) noexcept;

    bool contactsUsedUp() const noexcept { return contacts.size() == contactCapacity; }

    /// Applies a cell of continuous force. Call it after `mix` of the same cell, any number of
    /// times. During a force the resonator mixes as many of its modes as `allowance` permits, and
    /// drops none.
    bool
    applyForce(const ForceCell& force, std::int32_t allowance, const CellOutput& cell) noexcept;

    void reset() noexcept;

    /// Reports the groups of modes as heard in the current cell.
    void report(SoundingGroups& groups) const noexcept;

    bool ringing() const noexcept {
        return !activeBlocks.empty() || !contacts.empty() || !clicks.empty();
    }
    bool silent() const noexcept { return !ringing() && !fader.active(); }
    std::int32_t modesRinging() const noexcept { return demanded.modes; }
    std::int32_t modesMixed() const noexcept { return mixedLastCell; }
    std::size_t channelsSounding() const noexcept { return bank.channels(); }
    std::int32_t groupCount() const noexcept { return static_cast<std::int32_t>(bank.size()); }
    std::int32_t groupsAudible() const noexcept {
        return static_cast<std::int32_t>(bank.poles().audibleCount());
    }
    /// Number of mixed modes, including those that strikes have added since `mix`.
    std::int32_t modesMixedNow() const noexcept {
        return static_cast<std::int32_t>(mixedModes.size());
    }

private:
    /// G0 and H of a contact, summed over some modes, for each channel.
    struct ForcedMotion {
        std::array<double, maximumChannels> steadyVelocity{};
        std::array<std::complex<double>, maximumChannels> swing{};
    };

    /// A contact under way; its free part is in the states of the modes.
    struct Contact {
        Strike strike;   ///< duration kept clear of resonances
        Listening heard; ///< as at its start
        std::int64_t startCell = 0;
        double startSample = 0;
        ForcedMotion mixed{}; ///< of the mixed modes
        ForcedMotion tube{};  ///< the tube's part of `mixed`
    };

    /// One block of the bank's modes, one bit each. A block without ringing modes is inactive. Its
    /// states stay at grid point `restsSince` until they are needed.
    struct Block {
        std::uint16_t rings = 0; ///< above τ
        std::uint16_t mixed = 0;
        bool active = false;
        std::int64_t restsSince = 0;
        double restsAtDampingLog = 0;
    };

    // ModalResonator.cpp: the sets of ringing and mixed modes.
    bool beginSoundingCell(std::int64_t cell,
                           const SynthesisSettings& settings,
                           bool settingsChanged) noexcept;
    void survey() noexcept;
    void chooseModes(std::int32_t share) noexcept;
    void selectStrongest(std::size_t most) noexcept;
    void listMixed() noexcept;
    void retireBlocks(std::int64_t grid) noexcept;
    void wakeBlocks() noexcept;
    void renderCell(const ChannelOutputs& outputs) noexcept;
    void fade(std::span<const std::int32_t> modes, float share) noexcept;
    /// Returns whether the motor's discs change the sound of the current cell.
    bool tubesPulse() const noexcept { return !tubeParts.empty() && !scratch.tubes.isFull(); }
    std::span<const ModePart> tubePartsOf(std::span<const ModeRun> runs) const noexcept;
    std::span<const ModePart> pulsing() const noexcept {
        return tubesPulse() ? tubePartsOf(mixedRuns) : std::span<const ModePart>();
    }
    float openingNow(std::size_t g) const noexcept;
    void fadeByDamper(const ChannelOutputs& sound, std::size_t count) const noexcept;
    void activate(std::size_t block) noexcept;
    bool bringUpToDate(std::size_t block, std::int64_t grid) noexcept;

    // ModalResonatorReport.cpp
    GroupStanding standing(std::size_t g) const noexcept;
    float amplitudeNow(std::size_t g) const noexcept;

    // ModalResonatorConditions.cpp: poles, damping, truncation.
    void applySettings(const SynthesisSettings& settings) noexcept;
    void movePoles() noexcept;
    void takeSilences() noexcept;
    void fadeInaudible() noexcept;
    bool inBand(std::size_t g) const noexcept;
    bool silenced(std::size_t g) const noexcept {
        return !silencedModes.empty() &&
               silencedModes[static_cast<std::size_t>(groupStarts[g])] != 0;
    }
    bool audible(std::size_t g) const noexcept { return inBand(g) && !silenced(g); }
    bool holdsAboveTau() const noexcept;
    double dampingLog(std::int64_t grid) const noexcept;
    float tauEnergy() const noexcept { return static_cast<float>(tauPascals * tauPascals); }

    // ModalResonatorGroups.cpp: groups that follow the poles.
    void regroup(std::size_t groups) noexcept;
    void nameGroups(std::size_t groups) noexcept;
    void shareGroups(std::size_t groups) noexcept;
    void findTubeParts() noexcept;
    void handOnFlags() noexcept;
    void fadeChanges() noexcept;
    void rebuildBlocks() noexcept;

    // ModalResonatorStrike.cpp: from a strike to state increments and contacts.
    bool valid(const StrikePoint& point) const noexcept;
    bool valid(const Strike& strike, double sampleInCell) const noexcept;
    void prepareBank() noexcept;
    void widen(double farShare) noexcept;
    bool computeForced(const Contact& contact) noexcept;
    void joinStruck(std::int32_t allowance) noexcept;
    void admitWanted(std::int32_t allowance) noexcept;
    void listWanted(std::size_t most) noexcept;
    void admit(std::size_t g) noexcept;
    void soundContacts(const CellOutput& cell) noexcept;
    void addClick(const Contact& contact, const CellOutput& cell) noexcept;
    void soundClicks(const CellOutput& cell) noexcept;
    double addForced(const Contact& contact, const CellOutput& cell) const noexcept;
    void soundForced(const Contact& contact,
                     const ForcedMotion& motion,
                     int from,
                     std::size_t samples,
                     CellSound& sound) const noexcept;
    void startIncrements(double sign, double at) noexcept;
    void finishIncrements(const Contact& contact, double end) noexcept;
    BeforeSample beforeSample(double at) const noexcept;
    IncrementMove incrementMove(double seconds) const noexcept;
    void addIncrements(int from, int until, const CellOutput& cell) noexcept;
    void addToCell(const ChannelOutputs& sound,
                   std::size_t from,
                   std::size_t count,
                   const CellOutput& cell) const noexcept;
    void closeTubes(CellSound& tube,
                    std::size_t from,
                    std::size_t count,
                    const CellOutput& cell) const noexcept;
    void keepIncrements(int from) noexcept;
    void takeInIncrements(std::int64_t grid) noexcept;
    bool allMixed() const noexcept { return mixedModes.size() == bank.poles().audibleCount(); }
    void bringRestingUpToDate(std::int64_t grid) noexcept;
    void listWhatRings() noexcept;

    // ModalResonatorResidues.cpp: the residues of each group.
    bool computeResidues(const Contact& contact) noexcept;
    void mergeResidues(ChannelResidues& residues) noexcept;
    void blendNear(float farShare, ChannelResidues& residues) const noexcept;
    void findLost() noexcept;
    void findRadiation(std::int32_t radiationDirection) noexcept;

    // ModalResonatorContact.cpp: contacts under way.
    void hold(Contact& contact, std::span<const ModeRun> modes, double factor) noexcept;
    void
    addMotion(std::span<const ModeRun> modes, double factor, ForcedMotion& motion) const noexcept;
    /// Returns the ratio of a contact's residues to the other contact's, or 0 if it differs from
    /// mode to mode.
    static double shareOfResidues(const Contact& contact, const Contact& other) noexcept;
    enum class Forced { freed, held };
    void moveContacts(Forced become) noexcept;
    void moveContact(Contact& contact, double factor, Forced become) noexcept;
    std::complex<double>
    phaseAt(const Contact& contact, std::int64_t cell, double sample) const noexcept;

    // ModalResonatorForce.cpp: continuous contact.
    /// The object's response within a cell.
    struct Answer {
        alignas(64) CellSound sound;
        alignas(64) CellSound tube; ///< the tube's part of `sound`; only set if tubesPulse()
    };
    void admitForced(std::int32_t allowance) noexcept;
    bool valid(const ForcePlace& place) const noexcept;
    void answer(const ForcePoint& at, const Listening& heard, ForceResponse& response) noexcept;
    const ForceResponse&
    responseAt(const ForcePoint& at, const Listening& heard, ForceResponses& known) noexcept;
    void answerAt(const ForcePlace& place,
                  const Listening& heard,
                  ForceResponses& known,
                  ModeResidues& residues,
                  Answer& answer) noexcept;
    void soundForce(std::span<const float, cellSamples> impulses,
                    const Answer& start,
                    const Answer& end,
                    const CellOutput& cell) const noexcept;

    std::shared_ptr<const ModalObject> object;
    double slotSizeRatio;
    std::optional<PitchMode> pitch;
    std::size_t outputChannels;
    double sampleRate;
    double cellSeconds;

    // Members that a silent cell reads.
    std::int64_t cellIndex = -1; ///< the current cell
    bool controlsChanged = true;
    std::vector<std::int32_t> activeBlocks; ///< ascending
    std::vector<Contact> contacts;
    std::vector<Contact> clicks; ///< of the rigid body, stored as contacts with a sine response
    std::optional<IncrementMove>
        keptIncrements; ///< move of the pending `increments` to the next grid point

    // Requested values and values in effect.
    double requestedDamping = 0;
    double requestedFrequencyRatio = 1;
    std::optional<LiveMaterial> requestedMaterial; ///< empty: the settings'
    std::vector<std::uint8_t> requestedSilences;   ///< [M], or empty: none
    bool silencesChange = false;
    std::vector<std::uint8_t> silencedModes; ///< [M], or empty: none
    PoleLaw law;
    bool polesBehind = false; ///< the bank does not yet follow `law` and `compression`
    Listening listening;      ///< for strikes from now on
    RigidRadiator rigidBody;  ///< at the reference size
    double sizeNow = 1;       ///< size over the reference size, for strikes from now on
    /// Frequency times size over the reference's, the radiation table's argument: as wanted, and as
    /// last read with `radiationHeardFrom` for `StrikePoint::radiationDirection`.
    double wantedRadiationRatio = 1;
    double radiationRatio = 0;
    std::int32_t radiationHeardFrom = -1;
    double compression = 1;
    double tauPascals = 0; ///< τ in Pa, at least the floor below which states become 0
    double damping = 0;    ///< δ
    double dampingLogBase = 0;
    std::int64_t dampingSince = 0;

    // Groups.
    ModeWeights modeWeights;                  ///< [M] `summedSquareShapes`
    std::vector<std::int32_t> groupStarts;    ///< [G+1]
    double thicknessRatio = 1;                ///< 1 if the object has no live thickness
    std::vector<double> modeEigenvalues;      ///< [M] reference eigenvalues at that thickness
    std::vector<double> referenceEigenvalues; ///< [G] the same of the groups
    bool eigenvaluesAreBehind = false; ///< both ignore a new thickness or imperfection so far
    double imperfection = 0;
    std::vector<ModePair> pairs;
    std::vector<ModeDamping> dampings;      ///< [M], or empty: the law's
    std::vector<ModeDamping> groupDampings; ///< [G], or empty: the law's
    std::vector<float> tubeShares;          ///< [M] (TubeShares.h)
    std::vector<ModePart> tubeParts;        ///< groups that bar and tube share, ascending
    std::vector<float> lostShares;          ///< of the pairs in every group (ModeCompression.h)
    std::optional<PoleLaw> lostSharesLaw;   ///< law that `lostShares` belong to

    ModalBank bank;
    ModeFader fader;
    std::vector<Block> blocks;
    std::vector<std::int32_t> mixedModes; ///< ascending
    std::vector<ModeRun> mixedRuns;
    std::array<std::vector<std::complex<float>>, maximumChannels> radiationWeights; ///< [M]
    bool mixedIsRinging = true; ///< the mixed modes are the ringing ones
    ModeDemand demanded;
    std::int32_t mixedLastCell = 0;

    StateIncrements increments; ///< of the last strike or the last end of a contact

    std::uint64_t responseVersion = 1;
    static constexpr std::int64_t never = -2;
    std::int64_t forcedCell = never;            ///< the last cell with a force
    Listening listeningAtStart, listeningAtEnd; ///< of that cell

    static bool isSet(std::uint16_t bits, std::size_t g) noexcept {
        return (bits >> (g % modeBlock) & 1u) != 0;
    }
    /// Calls `visit` with the mode of each set bit of a block.
    template <class Visit>
    static void forEachMode(std::size_t block, std::uint16_t bits, Visit visit) {
        for (unsigned rest = bits; rest != 0; rest &= rest - 1)
            visit(static_cast<std::int32_t>(block * modeBlock) + std::countr_zero(rest));
    }
    /// Keeps the `most` modes with the largest energy; of two equal ones the lower index.
    static void
    keepLoudest(std::vector<std::int32_t>& modes, const float* energies, std::size_t most) noexcept;

    SynthesisScratch& scratch;
};

} // namespace idiophone
