// SPDX-License-Identifier: Apache-2.0
// One object in the mix, with its size and pitch.
#pragma once

#include "Object/ModalObject.h"
#include "Synth/LiveConditions.h"

#include <memory>
#include <optional>

namespace idiophone {

/// Slots may share a modal object; each has its own state.
struct SynthesiserSlot {
    std::shared_ptr<const ModalObject> object;
    double sizeRatio = 1; ///< > 0: scale of the object; λ ∝ 1/size², mass ∝ size³
    /// The pitch that `SynthesisSettings::keepPitch` keeps. Without it, the slot's pitch follows
    /// material and size.
    std::optional<PitchMode> pitch = {};
};

/// Returns the conditions of a slot with an object. Its own frequency ratio multiplies the
/// settings'.
inline LiveConditions liveConditions(const SynthesiserSlot& slot,
                                     const SynthesisSettings& settings,
                                     double slotFrequencyRatio = 1) noexcept {
    return liveConditions(slot.object->material, settings, slot.sizeRatio, slotFrequencyRatio,
                          slot.pitch ? &*slot.pitch : nullptr);
}

} // namespace idiophone
