#include "Plugin/WholeFile.h"

#include "Editor/Utf8.h"
#include "Object/FileBeside.h"

#include <ostream>

namespace idiophone {

Result<void> writeWhole(const juce::File& file, std::span<const std::byte> bytes) {
    const auto refuse = [&](const juce::String& fault) {
        return failure(
            (file.getFullPathName() + ": it cannot be written: " + fault + ".").toStdString());
    };
    if (const auto made = file.getParentDirectory().createDirectory(); made.failed())
        return refuse(made.getErrorMessage());
    const bool isWritten = replaceFile(pathOf(file), [&](std::ostream& stream) {
        stream.write(reinterpret_cast<const char*>(bytes.data()),
                     static_cast<std::streamsize>(bytes.size()));
    });
    if (!isWritten)
        return refuse("what is there cannot be replaced, or the disk is full");
    return {};
}

} // namespace idiophone
