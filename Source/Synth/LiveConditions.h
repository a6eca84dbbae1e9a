// What the settings make of an object while it is played: its poles, how it answers a blow and how
// it radiates. Pure numbers: no bank, no time, no samples.
#pragma once

#include "Object/Material.h"
#include "Synth/ModalPole.h"
#include "Synth/SynthesisSettings.h"

namespace idiophone {

/// The band in which modes sound, judged by their natural frequency: from here ...
inline constexpr double lowestSoundingHz = 20;
/// ... to below this share of the sample rate.
inline constexpr double highestSoundingShare = 0.49;

bool soundsAt(const ModalPole& pole, double sampleRateHz) noexcept;

/// The mode whose frequency is the pitch of what a key plays.
struct PitchMode {
    double hz = 0;         ///< > 0, damped, under settings that change nothing
    double eigenvalue = 0; ///< λ of the object's reference, > 0
    double bending = 0;    ///< ModalObject::bending, 0 without
    ModeDamping damping = {};

    bool operator==(const PitchMode&) const = default;
};

struct LiveConditions {
    PoleLaw law;
    double gainRatio = 1;          ///< of residues near: 1/mass ratio
    double radiationGainRatio = 1; ///< of residues from afar, beside what the table tells
    /// What RadiationTable::weightsAt looks up: frequencies times size, relative to the reference.
    /// A live thickness moves each mode by a ratio of its own; the weights stay those of the shapes
    /// at the thickness that was analysed.
    double radiationRatio = 1;

    /// By what the natural frequencies of the reference are multiplied.
    double frequencyRatio() const noexcept;
};

/// Returns the conditions of an object with that reference material; figures of either that are not
/// positive count as equal to the other's. The slot's size and frequency ratios (> 0) come on top
/// of the settings'. Where the settings keep the pitch, `pitch` sounds at its frequency times the
/// frequency ratios, whatever the material, size and thickness; nullptr has no pitch to keep. The
/// thickness acts on each mode beside (ModalObject::eigenvalueAt).
LiveConditions liveConditions(const Material& reference,
                              const SynthesisSettings& settings,
                              double slotSizeRatio = 1,
                              double slotFrequencyRatio = 1,
                              const PitchMode* pitch = nullptr) noexcept;

} // namespace idiophone
