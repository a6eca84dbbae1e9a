// SPDX-License-Identifier: Apache-2.0
// Reads and writes files of modal objects in every format: .modal, and glTF with
// KHR_audio_rigid_bodies.
#pragma once

#include "Gltf/ObjectBytes.h"

#include <filesystem>

namespace idiophone {

/// Reads a .gltf or .glb file's first modal model, or a .modal file. The error is one sentence with
/// the file and its fault. Not for the audio thread.
Result<ModalObject> readObject(const std::filesystem::path& file);

/// Writes a .glb file if the extension is that, else a .modal file. Replaces an existing file only
/// by a complete one. The error is one sentence with the file and its fault: it cannot be written,
/// or the extension is .gltf, which is not written.
Result<void> writeObject(const ModalObject& object, const std::filesystem::path& file);

/// Returns whether the file is a glTF file with a modal model, so that it is an object and not only
/// a mesh. Reads the file.
bool hasModalModel(const std::filesystem::path& file);

} // namespace idiophone
