// SPDX-License-Identifier: Apache-2.0
// The contacts of mallets with a resonator that are under way, and the clicks of its rigid body.
#pragma once

#include "Synth/AccelerationNoise.h"
#include "Synth/ActiveModes.h"
#include "Synth/GroupResidues.h"
#include "Synth/PendingIncrements.h"

#include <array>
#include <complex>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

namespace idiophone {

/// G0 and H of a contact (StrikeKernel.h), summed over some modes, for each channel.
struct ForcedMotion {
    std::array<double, maximumChannels> steadyVelocity{};
    std::array<std::complex<double>, maximumChannels> swing{};
};

/// The forced part of a strike's response. The free part is in the states of the modes.
struct Contact {
    Strike strike;       ///< duration kept clear of resonances
    Listening listening; ///< as at its start
    std::int64_t startCell = 0;
    double startSample = 0;
    ForcedMotion mixed{}; ///< of the mixed modes
    ForcedMotion tube{};  ///< the tube's part of `mixed`

    HeardImpulse heard() const noexcept {
        return {strike.point, strike.impulseNewtonSeconds, listening};
    }

    /// Returns e^{iΩt} at a sample of a cell.
    std::complex<double>
    phaseAt(std::int64_t cell, double sample, double sampleRateHz) const noexcept {
        const double cells = static_cast<double>(cell - startCell);
        const double samples = cells * static_cast<int>(cellSize) + sample - startSample;
        const double turns = samples / (sampleRateHz * strike.durationSeconds);
        return std::polar(1.0, 2 * std::numbers::pi * turns);
    }
};

/// Memory is reserved by the constructor; every other member is for the audio thread.
class ContactSet {
public:
    static constexpr std::size_t capacity = 64;

    /// The arguments must outlive this object.
    ContactSet(const ModalObject& object,
               ModalBank& bank,
               BankOutput& output,
               ActiveModes& active,
               GroupResidues& residues,
               SynthesisScratch& scratch);

    bool empty() const noexcept { return contacts.empty(); }
    bool full() const noexcept { return contacts.size() == capacity; }
    bool sounding() const noexcept { return !contacts.empty() || !clicks.empty(); }

    /// Computes the scratch's residues and contact. Returns false if a residue is absurdly large.
    bool compute(const Contact& contact) noexcept;
    /// Computes the scratch's contact for an impulse.
    void computeImpulse() noexcept;
    /// Adds `factor` times the forced motion of modes, with the scratch's residues and contact, to
    /// the contact.
    void hold(Contact& contact, std::span<const ModeRun> modes, double factor = 1) const noexcept;
    /// Lets modes join all contacts.
    void join(std::span<const ModeRun> modes) noexcept;
    /// Adds the forced part to cell number `index` and returns the contact's end in its samples.
    double sound(const Contact& contact, std::int64_t index, const CellOutput& cell) const noexcept;
    /// Takes a contact that outlasts the cell. The set must not be full.
    void add(const Contact& contact) noexcept { contacts.push_back(contact); }
    /// Adds the sound of all contacts and clicks, and ends those that end in this cell.
    void mix(PendingIncrements& increments, std::int64_t index, const CellOutput& cell) noexcept;

    /// Starts the click of the rigid body, which has no near sound. `size` is over the reference.
    void startClick(const Contact& contact,
                    double size,
                    std::size_t outputChannels,
                    std::int64_t index,
                    const CellOutput& cell) noexcept;

    /// Turns the forced parts of all contacts into free motion at the grid point, or takes them out
    /// again. Poles, damping and radiation may change in between.
    void free(std::int64_t grid) noexcept { move(Forced::freed, grid); }
    void holdAgain(std::int64_t grid) noexcept { move(Forced::held, grid); }

    void widen() noexcept; ///< copies the first channel to the second
    void reset() noexcept;

private:
    enum class Forced { freed, held };

    void move(Forced become, std::int64_t grid) noexcept;
    void move(Contact& contact, double factor, Forced become, std::int64_t grid) noexcept;
    void
    addMotion(std::span<const ModeRun> modes, double factor, ForcedMotion& motion) const noexcept;
    void render(const Contact& contact,
                const ForcedMotion& motion,
                std::complex<double> phase,
                std::size_t samples,
                CellSound& sound) const noexcept;

    const ModalObject& object;
    ModalBank& bank;
    BankOutput& output;
    ActiveModes& active;
    GroupResidues& residues;
    SynthesisScratch& scratch;
    RigidRadiator rigidBody; ///< at the reference size
    std::vector<Contact> contacts;
    std::vector<Contact> clicks; ///< contacts with a sine response
};

} // namespace idiophone
