// The force of a contact that scrapes or rolls over a surface, cell by cell (van den Doel, Kry &
// Pai 2001, sections 5.2 and 5.3). It knows neither the object nor where on it the contact is.
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
    roll    ///< that through a low-pass, and through the object's modes where they are coupled
};

/// A figure out of its range counts as its nearest bound, NaN as the lower one.
struct ContactForceSettings {
    ContactKind kind = ContactKind::scrape;
    double rollLowPassHz = 100; ///< Butterworth, second order; 1 to 20000
    double rollDryMix = 0.1;    ///< 0 to 1: how much of the scrape a roll keeps
    /// 0 to 10: how much a roll adds of the scrape filtered by the coupled modes, whose filters
    /// pass their own frequency unchanged. A mode answers the force filtered by its own pole as a
    /// gamma-tone of order 2.
    double rollModalCoupling = 0;

    bool operator==(const ContactForceSettings&) const = default;
};

/// A mode that a roll is coupled to: the envelope d/√((ω − 2πf)² + d²) of its filter.
struct CoupledMode {
    double frequencyHz = 0;      ///< f > 0: ModalObject::dampedFrequencyHz
    double dampingPerSecond = 0; ///< d > 0: α, ModalObject::decayPerSecond
};

/// How a contact moves at a grid point. NaN counts as 0, as does a negative force; of a negative
/// speed the magnitude counts. Both are bounded by what no contact reaches (10⁶ m/s, 10⁹ N).
struct ContactMotion {
    double speedMetresPerSecond = 0;
    double normalForceNewtons = 0;
};

/// Constructed and destroyed off the audio thread; every other member is for the audio thread, and
/// neither allocates, locks nor throws. The same calls give the same bits.
class ContactForce {
public:
    static constexpr std::size_t maxCoupledModes = 8;

    /// `profile` is shared and not null. The seed says where on it the contact begins.
    ContactForce(std::shared_ptr<const SurfaceProfile> profile, std::uint64_t seed);

    /// Takes effect over the next cell.
    void setSettings(const ContactForceSettings& settings) noexcept;

    /// Modes beyond `maxCoupledModes` and modes whose figures are out of range are left out. A mode
    /// that keeps its place keeps ringing.
    void setCoupledModes(std::span<const CoupledMode> modes) noexcept;

    /// Writes the force in newtons, along the normal or the direction of motion as the caller
    /// likes, while the motion goes linearly from what it was to `motion` at the end of the cell.
    /// Its rms is roughness · √(v/v_max · F_n · 1 N) for a scrape: silent where v or F_n is 0 or
    /// v is below the surface's slowest. A contact ends with a cell to a motion of 0, 0. Returns
    /// whether the cell holds anything but zeros.
    bool render(const ContactMotion& motion, std::span<float, cellSamples> forceNewtons) noexcept;

    /// At rest, at the seed's place on the profile; the settings stay.
    void reset() noexcept;

private:
    /// What is interpolated over a cell.
    struct Levels {
        double step = 0; ///< samples of the profile a sample
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
