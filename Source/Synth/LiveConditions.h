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

/// Of an object with that reference material; figures of either that are not positive count as
/// equal to the other's. The slot's size and frequency ratios (> 0) come on top of the settings'.
/// The settings' thickness is not among it: it acts on each mode (ModalObject::eigenvalueAt).
LiveConditions liveConditions(const Material& reference,
                              const SynthesisSettings& settings,
                              double slotSizeRatio = 1,
                              double slotFrequencyRatio = 1) noexcept;

} // namespace idiophone
