#include "Plugin/WholeFile.h"

namespace idiophone {

Result<void> writeWhole(const juce::File& file, std::span<const std::byte> bytes) {
    const auto refuse = [&](const juce::String& fault) {
        return failure(
            (file.getFullPathName() + ": it cannot be written: " + fault + ".").toStdString());
    };
    if (const auto made = file.getParentDirectory().createDirectory(); made.failed())
        return refuse(made.getErrorMessage());
    const juce::TemporaryFile beside(file, juce::TemporaryFile::useHiddenFile);
    {
        juce::FileOutputStream stream(beside.getFile());
        stream.write(bytes.data(), bytes.size());
        stream.flush();
        if (const auto status = stream.getStatus(); status.failed())
            return refuse(status.getErrorMessage());
    }
    // The last bytes before a disk is full are written without a fault.
    if (beside.getFile().getSize() != static_cast<juce::int64>(bytes.size()))
        return refuse("there is no room for all of it");
    if (!beside.overwriteTargetFileWithTemporary())
        return refuse("what is there cannot be replaced");
    return {};
}

} // namespace idiophone
