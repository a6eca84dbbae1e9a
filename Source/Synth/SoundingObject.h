// One slot of the synthesiser: an object's groups of modes with their states, which of them ring,
// and which of them are mixed. It renders cells and takes strikes; the budget comes from outside.
#pragma once

#include "Object/ModalObject.h"
#include "Synth/ModalBank.h"
#include "Synth/ModeFader.h"
#include "Synth/QualityScaling.h"
#include "Synth/Strike.h"
#include "Synth/SynthesisSettings.h"

#include <complex>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace idiophone {

/// Memory is reserved by the constructor; every other member is for the audio thread. Ringing
/// states stand at the grid point at which the cell begun last starts, after `mix` at the one where
/// it ends.
class SoundingObject {
public:
    /// At most this many contacts are under way at a time.
    static constexpr std::size_t contactCapacity = 64;

    SoundingObject(std::shared_ptr<const ModalObject> object,
                   double sizeRatio,
                   double sampleRateHz);

    void setDamping(double dampingPerSecond) noexcept;
    void setFrequencyRatio(double ratio) noexcept;

    /// Moves to the grid point of cell `index`: applies what was set and drops modes at t_c
    /// (eq. 14). True where there is anything to mix.
    bool
    beginCell(std::int64_t index, const SynthesisSettings& settings, bool settingsChanged) noexcept;

    /// After `beginCell`: what quality scaling asks. Modes held by a contact are part of it.
    ModeDemand demand() const noexcept { return demanded; }

    /// Mixes the strongest `share` modes into the cell. While a contact is under way its modes
    /// stay, whatever the share: its forced part was summed over them.
    void mix(std::int32_t share, std::span<float, cellSamples> cell) noexcept;

    /// Adds a strike to the rest of the cell begun last; `allowance` bounds the modes mixed after
    /// it. A contact shorter than a thousandth of a sample is an impulse. False, and nothing done,
    /// where the contacts are used up or the strike is not valid for this object.
    bool strike(const Strike& strike,
                double sampleInCell,
                std::int32_t allowance,
                std::span<float, cellSamples> cell) noexcept;

    void reset() noexcept;

    bool ringing() const noexcept { return !ringingModes.empty() || !contacts.empty(); }
    bool silent() const noexcept { return !ringing() && !fader.active(); }
    std::int32_t modesRinging() const noexcept { return demanded.modes; }
    std::int32_t modesMixed() const noexcept { return mixedLastCell; }

private:
    /// One contact under way; its free part is in the states of the modes.
    struct Contact {
        Strike strike;        ///< its duration cleared of resonances
        double gainRatio = 1; ///< as of its start
        std::int64_t startCell = 0;
        double startSample = 0;
        double steadyVelocity = 0;  ///< G0 over the modes mixed
        std::complex<double> swing; ///< H over the modes mixed
    };

    // SoundingObject.cpp
    void measure() noexcept;
    void chooseModes(std::int32_t share) noexcept;

    // SoundingObjectConditions.cpp: poles, damping, truncation.
    void applySettings(const SynthesisSettings& settings) noexcept;
    void movePoles(const PoleLaw& newLaw) noexcept;
    void regroup() noexcept;
    void updateEnd(std::size_t g, std::int64_t grid) noexcept;
    void reviveTruncated() noexcept;
    void bringUpToDate(std::size_t g, std::int64_t grid) noexcept;
    void listRinging() noexcept;
    void dropEnded() noexcept;
    void noteFaint(std::size_t g, std::int64_t grid) noexcept;
    double dampingLog(std::int64_t grid) const noexcept;
    std::size_t index(std::int32_t g) const noexcept { return static_cast<std::size_t>(g); }

    // SoundingObjectStrike.cpp: residues, contacts.
    bool valid(const Strike& strike, double sampleInCell) const noexcept;
    void computeResidues(const Strike& strike, double gain) noexcept;
    void joinStruck(std::int32_t allowance) noexcept;
    void hold(Contact& contact, std::span<const std::int32_t> modes) noexcept;
    void moveContact(Contact& contact, double sign) noexcept;
    void soundContacts(std::span<float, cellSamples> cell) noexcept;
    double addForced(const Contact& contact, std::span<float, cellSamples> cell) const noexcept;
    void addKicks(double at, double until, std::span<float, cellSamples> cell) noexcept;
    void joinKicks(double at) noexcept;
    std::complex<double>
    phaseAt(const Contact& contact, std::int64_t cell, double sample) const noexcept;

    std::shared_ptr<const ModalObject> object;
    double slotSizeRatio;
    double sampleRate;
    double cellSeconds;

    // What was asked for, and what holds now.
    double requestedDamping = 0;
    double requestedFrequencyRatio = 1;
    bool controlsChanged = true;
    PoleLaw law;
    double gainRatio = 1; ///< residues over the reference's: 1/mass ratio
    double compression = 1;
    double tauVelocity = 0; ///< τ in m/s, at least the floor where states are flushed
    double damping = 0;     ///< δ
    double dampingLogBase = 0;
    std::int64_t dampingSince = 0;
    std::int64_t cellIndex = -1; ///< the cell begun last

    // Groups, and the conditions under which they were formed.
    std::vector<double> modeWeights;       ///< [M] mean-square shape
    std::vector<std::int32_t> groupStarts; ///< [G+1]
    std::size_t groupCount = 0;
    PoleLaw groupedLaw;
    double groupedCompression = 1;

    // Per group.
    struct Group {
        double referenceEigenvalue = 0;
        std::int64_t endCell = 0;   ///< t_c: rings in cells before this one
        std::int64_t stateCell = 0; ///< grid point of the state of a group that does not ring
        double stateLog = 0;        ///< ln of the amplitude there
        double stateDampingLog = 0; ///< dampingLog there
        std::uint32_t poleVersion = 0;
        bool rings = false;
        bool mixed = false;
        bool audible = false; ///< within the band at the pole it has
    };
    std::vector<Group> groups;
    ModalBank bank;
    ModeFader fader;
    std::uint32_t poleVersion = 1;
    std::int64_t faintUntil = 0; ///< from this cell on, states left by τ are below the floor
    std::vector<std::int32_t> ringingModes; ///< ascending
    std::vector<std::int32_t> mixedModes;   ///< ascending
    std::vector<double> amplitudes;         ///< [G] of ringing groups, at the cell's start
    ModeDemand demanded;
    std::int32_t mixedLastCell = 0;

    std::vector<Contact> contacts;

    // Scratch.
    std::vector<double> modeResidues;    ///< [M]
    std::vector<double> groupResidues;   ///< [G]
    std::vector<ModalState> kicks;       ///< [G] states to add, at the kick's time
    std::vector<double> kickedStates;    ///< [G,2]
    std::vector<ModalPole> audiblePoles; ///< [G]
    std::vector<std::int32_t> candidates;
    std::vector<std::int32_t> joining;
    std::vector<std::int32_t> leaving;
};

} // namespace idiophone
