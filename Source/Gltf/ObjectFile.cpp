// SPDX-License-Identifier: Apache-2.0
#include "Gltf/ObjectFile.h"

#include "Gltf/AudioRigidBodies.h"
#include "Gltf/GltfFile.h"
#include "Gltf/GltfObject.h"
#include "Gltf/ObjectGlb.h"
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

} // namespace

Result<ModalObject> readObject(const std::filesystem::path& file) {
    if (!isGltfFile(file))
        return readModalObject(file);
    return readBytes(file, largestFileBytes)
        .and_then([&](const std::string& bytes) {
            return firstObjectOf(withoutByteOrderMark(bytes), buffersIn(file.parent_path()));
        })
        .map_error(
            [&](const Error& fault) { return Error{shownNameOf(file) + ": " + fault.message}; });
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
    const auto document =
        GltfDocument::parse(withoutByteOrderMark(*bytes), buffersIn(file.parent_path()));
    return document && hasModalModels(*document);
}

} // namespace idiophone
