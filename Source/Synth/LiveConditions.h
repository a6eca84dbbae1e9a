// SPDX-License-Identifier: Apache-2.0
// The effect of the settings on an object while it is played: its poles, its gain and its
// radiation. Pure numbers: no bank, no time, no samples.
#pragma once

#include "Object/Material.h"
#include "Synth/ModalPole.h"
#include "Synth/SynthesisSettings.h"

namespace idiophone {

/// Lower edge of the band in which modes sound, in natural frequency.
inline constexpr double lowestSoundingHz = 20;
/// Upper edge of the band, as a share of the sample rate; exclusive.
inline constexpr double highestSoundingShare = 0.49;

inline bool soundsAt(const ModalPole& pole, double sampleRateHz) noexcept {
    return pole.stiffness >= stiffnessAt(lowestSoundingHz) &&
           pole.stiffness < stiffnessAt(highestSoundingShare * sampleRateHz);
}

/// The mode whose frequency is the pitch of a key's sound.
struct PitchMode {
    double hz = 0;         ///< damped, > 0, under settings that change nothing
    double eigenvalue = 0; ///< λ of the object's reference, > 0
    double bending = 0;    ///< ModalObject::bending, or 0
    ModeDamping damping = {};

    bool operator==(const PitchMode&) const = default;
};

struct LiveConditions {
    PoleLaw law;
    double gainRatio = 1;          ///< for the near sound: 1/mass ratio
    double radiationGainRatio = 1; ///< for the far sound, on top of the radiation table
    /// Argument of RadiationTable::weightsAt: frequency times size, relative to the reference. A
    /// live thickness moves each mode by its own ratio; the weights remain those of the shapes at
    /// the analysed thickness.
    double radiationRatio = 1;

    /// Returns the ratio of the natural frequencies to those of the reference.
    double frequencyRatio() const noexcept;
};

/// Returns the conditions of an object with that reference material. A material value that is not
/// positive counts as equal to its counterpart. The slot's size and frequency ratios (> 0) multiply
/// the settings'. If the settings keep the pitch, `pitch` sounds at its frequency times the
/// frequency ratios, whatever the material, size and thickness. nullptr: no pitch to keep. The
/// thickness acts on each mode separately (ModalObject::eigenvalueAt).
LiveConditions liveConditions(const Material& reference,
                              const SynthesisSettings& settings,
                              double slotSizeRatio = 1,
                              double slotFrequencyRatio = 1,
                              const PitchMode* pitch = nullptr) noexcept;

} // namespace idiophone
