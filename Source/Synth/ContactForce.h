// SPDX-License-Identifier: Apache-2.0
// The force of a contact that scrapes or rolls over a surface, cell by cell (van den Doel, Kry &
// Pai 2001, sections 5.2 and 5.3). It knows neither the object nor the place of the contact on it.
#pragma once

#include "Synth/Reson.h"
#include "Synth/SurfaceProfile.h"
#include "Synth/SynthesisSettings.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace idiophone {

enum class ContactKind {
    scrape, ///< the profile through the surface's reson
    roll    ///< the same through a low-pass, plus a part through the coupled modes
};

/// Values out of range are clamped; NaN counts as the minimum.
struct ContactForceSettings {
    ContactKind kind = ContactKind::scrape;
    double rollLowPassHz = 100; ///< Butterworth, second order; 1 to 20000
    double rollDryMix = 0.1;    ///< 0 to 1: the share of the scrape that a roll keeps
    /// 0 to 10: gain of the scrape filtered by the coupled modes in a roll. Each filter passes its
    /// own frequency unchanged. A mode that is driven through a filter with its own pole responds
    /// like a gamma-tone of order 2.
    double rollModalCoupling = 0;

    bool operator==(const ContactForceSettings&) const = default;
};

/// A mode that a roll is coupled to. Its filter has the envelope d/√((ω − 2πf)² + d²).
struct CoupledMode {
    double frequencyHz = 0;      ///< f > 0: ModalObject::dampedFrequencyHz
    double dampingPerSecond = 0; ///< d > 0: α, ModalObject::decayPerSecond
};

/// The motion of a contact at a grid point. NaN and negative forces count as 0. The sign of the
/// speed is ignored. Both are clamped far above real contacts (10⁶ m/s, 10⁹ N).
struct ContactMotion {
    double speedMetresPerSecond = 0;
    double normalForceNewtons = 0;
};

/// Constructed and destroyed off the audio thread; every other member is for the audio thread and
/// neither allocates, locks nor throws. The same calls give the same bits.
class ContactForce {
public:
    static constexpr std::size_t maxCoupledModes = 8;

    /// `profile` is shared and not null. The seed chooses where on the profile the contact begins.
    ContactForce(std::shared_ptr<const SurfaceProfile> profile, std::uint64_t seed);

    /// Takes effect gradually over the next cell.
    void setSettings(const ContactForceSettings& settings) noexcept;

    /// Ignores modes beyond `maxCoupledModes` and modes with values out of range. A mode that keeps
    /// its index keeps its filter state.
    void setCoupledModes(std::span<const CoupledMode> modes) noexcept;

    /// Writes the force in newtons; the caller chooses its direction. The motion changes linearly
    /// from the previous one to `motion` at the end of the cell. The rms of a scrape is roughness ·
    /// √(v/v_max · F_n · 1 N). It is silent if v or F_n is 0, or if v is below the surface's
    /// minimum speed. End a contact with a cell to a motion of 0, 0. Returns whether the cell holds
    /// anything but zeros.
    bool render(const ContactMotion& motion, std::span<float, cellSamples> forceNewtons) noexcept;

    /// Stops the contact and returns it to the seed's place on the profile. The settings are kept.
    void reset() noexcept;

private:
    /// Values that are interpolated over a cell.
    struct Levels {
        double step = 0; ///< profile samples per output sample
        double force = 0;
        double inputGain = 0;
        ResonPole pole;
        double dry = 1, filtered = 0, coupled = 0;
    };

    struct ModeFilter {
        ResonPole pole;
        double gain = 0;
        Reson state;
    };

    Levels levelsFor(const ContactMotion& motion) const noexcept;
    void clearFilters() noexcept;
    void clearModes() noexcept;
    double coupledModes(double input) noexcept;

    std::shared_ptr<const SurfaceProfile> profile;
    double firstPosition;
    double position;
    ContactForceSettings settings;
    Levels levels;
    Reson reson;
    ResonPole lowPassPole;
    double lowPassGain = 0;
    Reson lowPass;
    std::array<ModeFilter, maxCoupledModes> modeFilters{};
    std::size_t modeCount = 0;
};

} // namespace idiophone
