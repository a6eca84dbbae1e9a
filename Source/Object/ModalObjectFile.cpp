// SPDX-License-Identifier: Apache-2.0
#include "Object/ModalObjectFile.h"

#include "Object/FileBeside.h"
#include "Object/FileBytes.h"
#include "Object/Safetensors.h"

#include <ostream>

namespace idiophone {

Result<ModalObject> readModalObject(const std::filesystem::path& file) {
    constexpr std::uintmax_t fileLimitBytes = std::uintmax_t{1} << 32;
    const auto bytes = readBytes(file, fileLimitBytes);
    if (!bytes)
        return failure(shownNameOf(file) + ": " + bytes.error().message);
    return readModalObject(std::as_bytes(std::span(*bytes)), nameOf(file));
}

Result<void> writeModalObject(const ModalObject& object,
                              const std::filesystem::path& file,
                              ShapePrecision precision) {
    const auto refuse = [&](const char* sentence) {
        return failure(shownNameOf(file) + ": " + sentence);
    };
    const auto bytes = encodeModalObject(object, precision);
    if (!safetensors::hasReadableHeader(bytes))
        return refuse("the object's texts are too long for a file");
    const bool isWritten = replaceFile(file, [&](std::ostream& stream) {
        stream.write(reinterpret_cast<const char*>(bytes.data()),
                     static_cast<std::streamsize>(bytes.size()));
    });
    if (!isWritten)
        return refuse("the file cannot be written");
    return {};
}

} // namespace idiophone
