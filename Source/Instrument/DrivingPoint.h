// Models how an object yields at the struck point: as a free mass in series with a spring.
#pragma once

#include "Instrument/ContactLaw.h"
#include "Object/ModalObject.h"
#include "Synth/LiveConditions.h"
#include "Synth/Strike.h"
#include "Synth/SynthesisSettings.h"

#include <array>
#include <cstddef>

namespace idiophone {

/// The body that hits an object.
struct Striker {
    double massKg = 0;      ///< > 0
    double restitution = 1; ///< 0 to 1: rebound over approach on a rigid, heavy object
    ContactLaw law;
};

/// How long a striker stays in contact with an object, and the impulse that it transfers.
struct Collision {
    double contactSeconds = 0;
    double impulseNewtonSeconds = 0;
};

/// The mobility of an object along the normal of a point on its surface: 1/M of the rigid body with
/// its rotation, and φ²(p) of the modes. The default is a rigid wall. Nothing allocates, locks or
/// throws; any thread.
class DrivingPoint {
public:
    /// The lowest modes; the others are too stiff to move during a contact.
    static constexpr std::size_t maximumModes = 512;

    DrivingPoint() = default;
    /// Takes the material, size and thickness from the settings. `slotSizeRatio` > 0 scales the
    /// object further; `pitch` is the mode whose frequency it keeps if the settings ask for that.
    /// Tunings and bends change the sound only, not the struck object. The point's rows must be the
    /// object's.
    DrivingPoint(const ModalObject& object,
                 const StrikePoint& point,
                 const SynthesisSettings& settings,
                 double slotSizeRatio = 1,
                 const PitchMode* pitch = nullptr) noexcept;

    /// Returns the collision with a striker at a speed > 0 [m/s].
    ///
    /// Time: at the complex frequency s = r e^{iπ/4} a mode has the mobility φ² s/(s² + ω²) = B/s +
    /// C s, exactly, with B = φ²/(1 + (ω/r)⁴) and C = (ω/r²)² B. So at r = c/T the object is the
    /// mass 1/ΣB in series with a spring of the compliance ΣC, and T² = T_law(μ)² + π² μ ΣC, 1/μ =
    /// 1/m + ΣB. With c = 1.669 a hard impact on a point of constant mechanical resistance (an
    /// infinite plate) takes the momentum m v, as in Zener (1941). Six steps from T_law(m) come
    /// close to the solution. The equation can have three solutions, for example for a heavy
    /// mallet on a single slow mode. A fixed number of smooth steps does not jump between them.
    ///
    /// Impulse: J = (1 + e) m' v, 1/m' = 1/m + 1/M + Σ φ² |S(ωT)|², where S is the spectrum of the
    /// raised cosine. The pulse leaves the energy J² φ² |S|²/2 in a mode, so for e = 1 the impact
    /// conserves energy.
    Collision struckBy(const Striker& striker, double speedMetresPerSecond) const noexcept;

private:
    struct Yielding {
        double mobilityPerKg = 0;             ///< ΣB
        double complianceMetresPerNewton = 0; ///< ΣC
    };
    Yielding yieldingIn(double contactSeconds) const noexcept;
    double impulseMobilityPerKg(double contactSeconds) const noexcept;
    double contactSecondsOf(const Striker& striker, double speedMetresPerSecond) const noexcept;

    double rigidPerKg = 0; ///< 1/M and rotation
    std::size_t modes = 0;
    std::array<double, maximumModes> squaredShapes; ///< [modes] φ² [1/kg]
    std::array<double, maximumModes> eigenvalues;   ///< [modes] λ = ω² [rad²/s²]
};

} // namespace idiophone
