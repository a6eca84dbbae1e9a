// SPDX-License-Identifier: Apache-2.0
// Turns a modal model of KHR_audio_rigid_bodies into a modal object. docs/gltf.md gives the
// reasons.
#pragma once

#include "Gltf/AudioRigidBodies.h"

namespace idiophone {

/// The part of a node in the sound of its model.
struct GltfInstance {
    std::optional<std::size_t> surface = {}; ///< index into `AudioRigidBodies::surfaces`
    double gain = 1;
    double scale = 1; ///< of the sample points, > 0
    /// Whether the model describes the body at scale 1, so that its modes change with the scale, or
    /// as it is placed.
    bool isRetuned = false;
    std::optional<MassProperties> mass = {}; ///< of the body as it is; replaces the model's
};

/// Makes the object as it is heard by the draft: each mode radiates 2πf times what the impulse
/// gives it, into all directions alike. The object's mesh is the model's sample points with their
/// indices. Modes ascend in frequency. A model that Idiophone wrote becomes the object from which
/// it was written, unless its numbers were changed since; then it is like any other.
/// The error is the end of a sentence that begins with the file's name.
Result<ModalObject> objectOf(const GltfDocument& document,
                             const AudioRigidBodies& audio,
                             std::size_t model,
                             const GltfInstance& instance = {});

/// Parses a .gltf or .glb file as GltfDocument does. Returns the object of its first modal model,
/// with a note about other contents. The error is the end of a sentence that begins with the file's
/// name.
Result<ModalObject> firstObjectOf(std::string_view bytes, const GltfBufferReader& readBuffer = {});

/// Figures that the file leaves out are those of the library's material of that name, or of steel.
/// Without damping in the file, the law is the library's, too.
Material materialOf(const GltfAcousticMaterial& given);

/// A finish is between 0 (polished) and 1 (cast), as `Material::roughness`.
double roughnessOf(const GltfAcousticSurface& surface);
/// Returns the draft's finish of a roughness from 0 to 1: its representative ones, and in between.
GltfAcousticSurface surfaceOf(double roughness);

} // namespace idiophone
