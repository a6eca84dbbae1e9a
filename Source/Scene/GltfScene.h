// Turns a glTF file with rigid bodies into a scene (docs/gltf.md).
#pragma once

#include "Object/Result.h"
#include "Scene/Scene.h"

#include <filesystem>
#include <string_view>

namespace idiophone {

/// Reads the bodies of KHR_physics_rigid_bodies with the modal models and surfaces of
/// KHR_audio_rigid_bodies. A camera of the file is the listener. glTF's y becomes the scene's z.
/// The error is one sentence with the file and its fault: no bodies, or a part that is broken. Not
/// for the audio thread.
Result<Scene> readGltfScene(const std::filesystem::path& file);

/// Reads a scene from memory. `file` names it in errors; its folder has the buffers that are not in
/// the bytes.
Result<Scene> gltfScene(std::string_view bytes, const std::filesystem::path& file);

} // namespace idiophone
