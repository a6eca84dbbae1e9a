// How an object yields at the point that a mallet strikes: as a free mass in series with a spring.
#pragma once

#include "Instrument/ContactLaw.h"
#include "Object/ModalObject.h"
#include "Synth/LiveConditions.h"
#include "Synth/Strike.h"
#include "Synth/SynthesisSettings.h"

#include <array>
#include <cstddef>

namespace idiophone {

/// What hits an object.
struct Striker {
    double massKg = 0;      ///< > 0
    double restitution = 1; ///< 0 to 1: rebound over approach on something rigid and heavy
    ContactLaw law;
};

/// How long a striker stays in contact with an object, and what it leaves there.
struct Collision {
    double contactSeconds = 0;
    double impulseNewtonSeconds = 0;
};

/// The mobility of an object along the normal of a point on its surface: 1/M of the rigid body with
/// its rotation, and φ²(p) of the modes. The default is a rigid wall. Nothing allocates, locks or
/// throws; any thread.
class DrivingPoint {
public:
    /// Of the lowest ones; the others are too stiff to move while a contact lasts.
    static constexpr std::size_t mostModes = 512;

    DrivingPoint() = default;
    /// Under the material, size and thickness of these settings, for an object scaled by
    /// `slotSizeRatio` > 0 beside them, which keeps its pitch as these settings say. Tunings and
    /// bends move what sounds, not what is struck. The point's rows are the object's.
    DrivingPoint(const ModalObject& object,
                 const StrikePoint& point,
                 const SynthesisSettings& settings,
                 double slotSizeRatio = 1,
                 const PitchMode* pitch = nullptr) noexcept;

    /// Σ [1/kg] of everything that moves in a blow too short for any mode to turn back.
    double impulsiveMobilityPerKg() const noexcept;

    /// The blow of a striker at a speed > 0 [m/s].
    ///
    /// Time: at the complex frequency s = r e^{iπ/4} a mode answers a force by
    /// φ² s/(s² + ω²) = B/s + C s, exactly, with B = φ²/(1 + (ω/r)⁴) and C = (ω/r²)² B. So at
    /// r = c/T the object is the mass 1/ΣB in series with a spring of the compliance ΣC, and
    /// T² = T_law(μ)² + π² μ ΣC, 1/μ = 1/m + ΣB. c = 1.669 is the value at which a hard blow on a
    /// point of constant mechanical resistance (an infinite plate) leaves the momentum m v there,
    /// as it does after Zener (1941). Six steps from T_law(m) come close to the solution. A fixed
    /// number of smooth steps has no jump where the equation has three solutions, as it has for a
    /// heavy mallet on a single slow mode.
    ///
    /// Impulse: J = (1 + e) m' v, 1/m' = 1/m + 1/M + Σ φ² |S(ωT)|², where S is the spectrum of the
    /// raised cosine. J² φ² |S|²/2 is the energy that the pulse leaves in a mode, so for e = 1 the
    /// blow conserves energy.
    Collision struckBy(const Striker& striker, double speedMetresPerSecond) const noexcept;

private:
    struct Yielding {
        double mobilityPerKg = 0;             ///< ΣB
        double complianceMetresPerNewton = 0; ///< ΣC
    };
    Yielding yieldingIn(double contactSeconds) const noexcept;
    double impulseMobilityPerKg(double contactSeconds) const noexcept;
    double contactSecondsOf(const Striker& striker, double speed) const noexcept;

    double rigidPerKg = 0; ///< 1/M and rotation
    std::size_t modes = 0;
    std::array<double, mostModes> squaredShapes; ///< [modes] φ² [1/kg]
    std::array<double, mostModes> eigenvalues;   ///< [modes] λ = ω² [rad²/s²]
};

} // namespace idiophone
