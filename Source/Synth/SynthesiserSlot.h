// One object in the mix, and the size and pitch at which it is played.
#pragma once

#include "Object/ModalObject.h"
#include "Synth/LiveConditions.h"

#include <memory>
#include <optional>

namespace idiophone {

/// Slots may share a modal object, each with a state of its own.
struct SynthesiserSlot {
    std::shared_ptr<const ModalObject> object;
    double sizeRatio = 1; ///< > 0: the object scaled; λ ∝ 1/size², mass ∝ size³
    /// The pitch that `SynthesisSettings::keepPitch` keeps. Without it the slot follows material
    /// and size.
    std::optional<PitchMode> pitch = {};
};

/// Returns the conditions of a slot with an object, whose own frequency ratio is on top of the
/// settings'.
inline LiveConditions liveConditions(const SynthesiserSlot& slot,
                                     const SynthesisSettings& settings,
                                     double slotFrequencyRatio = 1) noexcept {
    return liveConditions(slot.object->material, settings, slot.sizeRatio, slotFrequencyRatio,
                          slot.pitch ? &*slot.pitch : nullptr);
}

} // namespace idiophone
