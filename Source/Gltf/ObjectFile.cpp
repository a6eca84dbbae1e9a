// SPDX-License-Identifier: Apache-2.0
#include "Gltf/ObjectFile.h"

#include "Gltf/GltfObject.h"
#include "Gltf/ObjectGlb.h"
#include "Gltf/RigidBodies.h"
#include "Object/ByteOrderMark.h"
#include "Object/FileBeside.h"
#include "Object/FileBytes.h"
#include "Object/ModalObjectFile.h"
#include "Object/SameName.h"

#include <ostream>
#include <string>

namespace idiophone {
namespace {

constexpr std::uintmax_t largestFileBytes = std::uintmax_t{2} << 30;

/// Returns sentences about what else is in the file; may be empty.
std::string notesOn(const GltfDocument& document, const AudioRigidBodies& audio) {
    std::string notes;
    if (audio.models.size() > 1)
        notes =
            "The first of " + std::to_string(audio.models.size()) + " modal models in its file.";
    if (hasRigidBodies(document))
        notes += (notes.empty() ? "" : " ") +
                 std::string("The file has rigid bodies: it is a scene, too (docs/gltf.md).");
    return notes;
}

/// The error is the end of a sentence.
Result<ModalObject> objectIn(std::string_view bytes, const std::filesystem::path& folder) {
    const auto document = GltfDocument::parse(withoutByteOrderMark(bytes), folder);
    if (!document)
        return failure(document.error().message);
    const auto audio = audioRigidBodies(*document);
    if (!audio)
        return failure(audio.error().message);
    if (audio->models.empty())
        return failure("it has no modal model (KHR_audio_rigid_bodies)");
    GltfInstance instance;
    for (const auto& node : audio->nodes)
        if (node.model == 0) {
            instance.surface = node.surface;
            break;
        }
    return objectOf(*document, *audio, 0, instance).map([&](ModalObject&& object) {
        if (const auto notes = notesOn(*document, *audio); !notes.empty())
            object.provenance.notes = notes;
        return std::move(object);
    });
}

Result<ModalObject> named(Result<ModalObject> object, const std::string& name) {
    return std::move(object).map_error(
        [&](const Error& error) { return Error{name + ": " + error.message}; });
}

} // namespace

Result<ModalObject> readObject(const std::filesystem::path& file) {
    if (!isGltfFile(file))
        return readModalObject(file);
    try {
        return named(readBytes(file, largestFileBytes).and_then([&](const std::string& bytes) {
            return objectIn(bytes, file.parent_path());
        }),
                     shownNameOf(file));
    } catch (const std::bad_alloc&) {
        return failure(shownNameOf(file) + ": it is too large for this machine's memory");
    }
}

Result<ModalObject> readObject(std::span<const std::byte> bytes, std::string_view name) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (!text.starts_with("glTF"))
        return readModalObject(bytes, name);
    try {
        return named(objectIn(text, {}), shownName(name));
    } catch (const std::bad_alloc&) {
        return failure(shownName(name) + ": it is too large for this machine's memory");
    }
}

Result<void> writeObject(const ModalObject& object, const std::filesystem::path& file) {
    if (!isGltfFile(file))
        return writeModalObject(object, file);
    if (!sameName(nameOf(file.extension()), ".glb"))
        return failure(shownNameOf(file) + ": objects are written as .glb, not as .gltf");
    if (!(object.dampedFrequencyHz(object.modeCount() - 1) > 0))
        return failure(shownNameOf(file) + ": none of the object's modes rings");
    const auto bytes = encodeGlb(object);
    const bool isWritten = replaceFile(file, [&](std::ostream& stream) {
        stream.write(reinterpret_cast<const char*>(bytes.data()),
                     static_cast<std::streamsize>(bytes.size()));
    });
    if (!isWritten)
        return failure(shownNameOf(file) + ": the file cannot be written");
    return {};
}

bool hasModalModel(const std::filesystem::path& file) {
    if (!isGltfFile(file))
        return false;
    const auto bytes = readBytes(file, largestFileBytes);
    if (!bytes)
        return false;
    const auto document = GltfDocument::parse(withoutByteOrderMark(*bytes), file.parent_path());
    return document && hasModalModels(*document);
}

} // namespace idiophone
