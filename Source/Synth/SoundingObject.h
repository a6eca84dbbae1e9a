// One slot of the synthesiser: an object's groups of modes with their states, which of them ring,
// and which of them are mixed. It renders cells and takes strikes; the budget comes from outside.
#pragma once

#include "Synth/AccelerationNoise.h"
#include "Synth/CellOutput.h"
#include "Synth/ForceCell.h"
#include "Synth/Imperfection.h"
#include "Synth/ModalBank.h"
#include "Synth/ModeFader.h"
#include "Synth/QualityScaling.h"
#include "Synth/SoundingGroups.h"
#include "Synth/Strike.h"
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

/// Memory is reserved by the constructor; every other member is for the audio thread. The states of
/// active blocks stand at the grid point at which the cell begun last starts, after `mix` at the
/// one where it ends.
class SoundingObject {
public:
    /// At most this many contacts are under way at a time.
    static constexpr std::size_t contactCapacity = 64;

    using ModeWeights = std::shared_ptr<const std::vector<double>>;

    /// `channels` 1 or 2: how many the cells handed over have. An object sounds in stereo from a
    /// strike that is heard from afar (`SynthesisSettings::radiation`) until it is silent again.
    /// `modeWeights` [M] are the object's `summedSquareShapes`, which all its slots share. `seed`
    /// draws its imperfection. `scratch` has room for this object and outlives it; objects on one
    /// thread share it.
    SoundingObject(SynthesiserSlot slot,
                   ModeWeights modeWeights,
                   std::uint32_t seed,
                   std::size_t channels,
                   double sampleRateHz,
                   SynthesisScratch& scratch);

    void setDamping(double dampingPerSecond) noexcept;
    void setFrequencyRatio(double ratio) noexcept;
    double frequencyRatio() const noexcept { return requestedFrequencyRatio; }
    /// Instead of the settings'; nothing: theirs. Its figures are in their ranges.
    void setMaterial(const std::optional<LiveMaterial>& material) noexcept;
    /// From the next `beginCell` on modes that are not 0 here ([modes of the object], or empty:
    /// none) are not heard. They fade out and in, and ring on unheard in between.
    void setSilencedModes(std::span<const std::uint8_t> silenced) noexcept;

    /// Moves to the grid point of cell `index`: applies what was set and drops modes at t_c
    /// (Raghuvanshi & Lin 2006, eq. 14). True where there is anything to mix.
    bool beginCell(std::int64_t index,
                   const SynthesisSettings& settings,
                   bool settingsChanged) noexcept {
        if (keptKicks || settingsChanged || controlsChanged || !silent())
            return beginSoundingCell(index, settings, settingsChanged);
        cellIndex = index;
        return false;
    }

    /// After `beginCell`: what quality scaling asks. Modes held by a contact are part of it.
    ModeDemand demand() const noexcept { return demanded; }

    /// Mixes the strongest `share` modes into the cell. While a contact is under way its modes
    /// stay, whatever the share: its forced part was summed over them.
    void mix(std::int32_t share, const CellOutput& cell) noexcept;

    /// After `mix`, before a strike: what was set since `beginCell` holds for the strike, and for
    /// what rings from the next grid point on, at which its states stand. Where a contact is under
    /// way, all of it waits for the next cell.
    void catchUp(const SynthesisSettings& settings) noexcept;

    /// Adds a strike to the rest of the cell begun last; `allowance` bounds the modes mixed after
    /// it. A contact shorter than a thousandth of a sample is an impulse. False, and nothing done,
    /// where the contacts are used up or the strike is not valid for this object.
    bool strike(const Strike& strike,
                double sampleInCell,
                std::int32_t allowance,
                const CellOutput& cell) noexcept;

    bool contactsUsedUp() const noexcept { return contacts.size() == contactCapacity; }

    /// Applies a cell of continuous force, after `mix` of the same cell and any number of times.
    /// While it lasts all its modes are mixed that `allowance` has room for, and none is dropped.
    bool
    applyForce(const ForceCell& force, std::int32_t allowance, const CellOutput& cell) noexcept;

    void reset() noexcept;

    /// What is heard of its groups of modes, as of the cell begun last.
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
        return static_cast<std::int32_t>(bank.audibleCount());
    }
    /// The same with those that strikes have added since.
    std::int32_t modesMixedNow() const noexcept {
        return static_cast<std::int32_t>(mixedModes.size());
    }

private:
    /// G0 and H of a contact over some modes, for each channel.
    struct ForcedMotion {
        std::array<double, mostChannels> steadyVelocity{};
        std::array<std::complex<double>, mostChannels> swing{};
    };

    /// One contact under way; its free part is in the states of the modes.
    struct Contact {
        Strike strike; ///< its duration cleared of resonances
        Hearing heard; ///< as of its start
        std::int64_t startCell = 0;
        double startSample = 0;
        ForcedMotion mixed{}; ///< of the modes mixed
        ForcedMotion tube{};  ///< of these, what the tube adds
    };

    /// One block of the bank's modes, a bit each. A block of which nothing rings is not active: its
    /// states rest as of the grid point `restsSince` until something needs them.
    struct Block {
        std::uint16_t rings = 0; ///< above τ
        std::uint16_t mixed = 0;
        bool active = false;
        std::int64_t restsSince = 0;
        double restsAtDampingLog = 0;
    };

    // SoundingObject.cpp: which modes ring and are mixed.
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
    /// Whether a motor changes what is heard in the cell begun last.
    bool tubesPulse() const noexcept { return !tubeParts.empty() && !scratch.tubes.isFull(); }
    std::span<const ModePart> tubePartsOf(std::span<const ModeRun> runs) const noexcept;
    std::span<const ModePart> pulsing() const noexcept {
        return tubesPulse() ? tubePartsOf(mixedRuns) : std::span<const ModePart>();
    }
    float openingNow(std::size_t g) const noexcept;
    void fadeByDamper(const ChannelOutputs& sound, std::size_t count) const noexcept;
    void activate(std::size_t block) noexcept;
    bool bringUpToDate(std::size_t block, std::int64_t grid) noexcept;

    // SoundingObjectReport.cpp
    GroupStanding standing(std::size_t g) const noexcept;
    float amplitudeNow(std::size_t g) const noexcept;

    // SoundingObjectConditions.cpp: poles, damping, truncation.
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

    // SoundingObjectGroups.cpp: groups that follow the poles.
    void regroup(std::size_t groups) noexcept;
    void nameGroups(std::size_t groups) noexcept;
    void shareGroups(std::size_t groups) noexcept;
    void findTubeParts() noexcept;
    void handOnFlags() noexcept;
    void fadeChanges() noexcept;
    void rebuildBlocks() noexcept;

    // SoundingObjectStrike.cpp: from a strike to kicks and contacts.
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
    void startKicks(double sign, double at) noexcept;
    void finishKicks(const Contact& contact, double end) noexcept;
    BeforeSample beforeSample(double at) const noexcept;
    KickMove kickMove(double seconds) const noexcept;
    void addKicks(int from, int until, const CellOutput& cell) noexcept;
    void addToCell(const ChannelOutputs& sound,
                   std::size_t from,
                   std::size_t count,
                   const CellOutput& cell) const noexcept;
    void closeTubes(CellSound& tube,
                    std::size_t from,
                    std::size_t count,
                    const CellOutput& cell) const noexcept;
    void keepKicks(int from) noexcept;
    void takeInKicks(std::int64_t grid) noexcept;
    bool allMixed() const noexcept { return mixedModes.size() == bank.audibleCount(); }
    void bringRestingUpToDate(std::int64_t grid) noexcept;
    void listWhatRings() noexcept;

    // SoundingObjectResidues.cpp: what is heard of each group.
    bool computeResidues(const Contact& contact) noexcept;
    void mergeResidues(ChannelResidues& residues) noexcept;
    void blendNear(float farShare, ChannelResidues& residues) const noexcept;
    void findLost() noexcept;
    void findRadiation(std::int32_t heardFrom) noexcept;

    // SoundingObjectContact.cpp: contacts under way.
    void hold(Contact& contact, std::span<const ModeRun> modes, double factor) noexcept;
    void
    addMotion(std::span<const ModeRun> modes, double factor, ForcedMotion& motion) const noexcept;
    /// What a contact adds to the residue of every mode, over what the other one does; 0 where that
    /// differs from mode to mode.
    static double shareOfResidues(const Contact& contact, const Contact& other) noexcept;
    enum class Forced { freed, held };
    void moveContacts(Forced become) noexcept;
    void moveContact(Contact& contact, double factor, Forced become) noexcept;
    std::complex<double>
    phaseAt(const Contact& contact, std::int64_t cell, double sample) const noexcept;

    // SoundingObjectForce.cpp: continuous contact.
    /// The object's answer within a cell.
    struct Answer {
        alignas(64) CellSound sound;
        alignas(64) CellSound tube; ///< of this, what the tube adds; only while tubes pulse
    };
    void admitForced(std::int32_t allowance) noexcept;
    bool valid(const ForcePlace& place) const noexcept;
    void answer(const ForcePoint& at, const Hearing& heard, ForceResponse& response) noexcept;
    const ForceResponse&
    responseAt(const ForcePoint& at, const Hearing& heard, ForceResponses& known) noexcept;
    void answerAt(const ForcePlace& place,
                  const Hearing& heard,
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

    // What a cell in which nothing sounds looks at.
    std::int64_t cellIndex = -1; ///< the cell begun last
    bool controlsChanged = true;
    std::vector<std::int32_t> activeBlocks; ///< ascending
    std::vector<Contact> contacts;
    std::vector<Contact> clicks;       ///< of the rigid body, as contacts that answer with a sine
    std::optional<KickMove> keptKicks; ///< on their way to the grid point where states take them in

    // What was asked for, and what holds now.
    double requestedDamping = 0;
    double requestedFrequencyRatio = 1;
    std::optional<LiveMaterial> requestedMaterial; ///< nothing: the settings'
    std::vector<std::uint8_t> requestedSilences;   ///< [M], or empty: none
    bool silencesChange = false;
    std::vector<std::uint8_t> silencedModes; ///< [M], or empty: none
    PoleLaw law;
    bool polesBehind = false; ///< the bank is not yet that of `law` and `compression`
    Hearing hearing;          ///< of strikes from now on
    RigidRadiator rigidBody;  ///< at the reference
    double sizeNow = 1;       ///< over the reference's, as of strikes from now on
    /// Frequency times size over the reference's: where the radiation table is to be read, and
    /// where and for which `StrikePoint::heardFrom` it was.
    double wantedRadiationRatio = 1;
    double radiationRatio = 0;
    std::int32_t radiationHeardFrom = -1;
    double compression = 1;
    double tauPascals = 0; ///< τ, at least the floor where states are flushed
    double damping = 0;    ///< δ
    double dampingLogBase = 0;
    std::int64_t dampingSince = 0;

    // Groups.
    ModeWeights modeWeights;                  ///< [M] `summedSquareShapes`
    std::vector<std::int32_t> groupStarts;    ///< [G+1]
    double thicknessRatio = 1;                ///< 1 where the object has none live
    std::vector<double> modeEigenvalues;      ///< [M] of the reference at that thickness
    std::vector<double> referenceEigenvalues; ///< [G] of the groups
    bool eigenvaluesAreBehind = false;        ///< both are not yet those of these two:
    double imperfection = 0;
    std::vector<ModePair> pairs;
    std::vector<ModeDamping> dampings;      ///< [M], or empty: the law's
    std::vector<ModeDamping> groupDampings; ///< [G], or empty: the law's
    std::vector<float> tubeShares;          ///< [M] (TubeShares.h)
    std::vector<ModePart> tubeParts;        ///< ascending: of the groups that bar and tube share
    std::vector<float> lostShares;          ///< of the pairs of every group (ModeCompression.h)
    std::optional<PoleLaw> lostSharesLaw;   ///< for which they hold

    ModalBank bank;
    ModeFader fader;
    std::vector<Block> blocks;
    std::vector<std::int32_t> mixedModes; ///< ascending
    std::vector<ModeRun> mixedRuns;
    std::array<std::vector<std::complex<float>>, mostChannels> radiationWeights; ///< [M]
    bool mixedIsRinging = true; ///< the modes mixed are those that ring
    ModeDemand demanded;
    std::int32_t mixedLastCell = 0;

    ModeKicks kicks; ///< of the last strike or end of a contact

    std::uint64_t responseVersion = 1;
    static constexpr std::int64_t never = -2;
    std::int64_t forcedCell = never;  ///< the last cell that was forced
    Hearing heardAtStart, heardAtEnd; ///< of that cell

    static bool isSet(std::uint16_t bits, std::size_t g) noexcept {
        return (bits >> (g % modeBlock) & 1u) != 0;
    }
    /// Calls `visit` with the mode of each bit of a block.
    template <class Visit>
    static void forEachMode(std::size_t block, std::uint16_t bits, Visit visit) {
        for (unsigned rest = bits; rest != 0; rest &= rest - 1)
            visit(static_cast<std::int32_t>(block * modeBlock) + std::countr_zero(rest));
    }
    /// Leaves the `most` modes of greatest energy, the lower one of two equals.
    static void
    keepLoudest(std::vector<std::int32_t>& modes, const float* energies, std::size_t most) noexcept;

    SynthesisScratch& scratch;
};

} // namespace idiophone
