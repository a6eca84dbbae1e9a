#include "Console/SofaHead.h"

#include "Console/SofaTable.h"
#include "Object/FileBytes.h"
#include "Object/TextFile.h"

#include <fstream>
#include <juce_core/juce_core.h>
#include <optional>
#include <string>

namespace idiophone {
namespace {

// A limit of clock time, above the limit of processor time.
constexpr int patienceMilliseconds = 1000 * (2 * sofaPatienceSeconds);

/// Returns the table that the other process wrote, or nothing. juce::ChildProcess has no exit code
/// after a signal, so only the table counts.
std::optional<std::string> tableOf(const std::filesystem::path& file, int sampleRateHz) {
    const juce::TemporaryFile table(".table");
    const auto self = juce::File::getSpecialLocation(juce::File::currentExecutableFile);
    std::error_code ignored;
    // Absolute, so that no name looks like an option.
    const auto path =
        juce::String::fromUTF8(std::filesystem::absolute(file, ignored).u8string().c_str());
    juce::ChildProcess reader;
    if (!reader.start({self.getFullPathName(), "sofa-table", path, juce::String(sampleRateHz),
                       table.getFile().getFullPathName()},
                      0))
        return std::nullopt;
    if (!reader.waitForProcessToFinish(patienceMilliseconds))
        reader.kill();
    const auto tableName = table.getFile().getFullPathName();
    auto read = readTextFile(reinterpret_cast<const char8_t*>(tableName.toRawUTF8()));
    if (!read)
        return std::nullopt;
    return std::move(*read);
}

} // namespace

Result<std::shared_ptr<const HeadResponses>> readSofaHead(const std::filesystem::path& file,
                                                          int sampleRateHz) {
    const auto refuse = [&](const std::string& sentence) {
        return failure(nameOf(file) + ": " + sentence);
    };
    std::error_code fault;
    if (std::filesystem::is_directory(file, fault))
        return refuse("it is a directory");
    const auto bytes = std::filesystem::file_size(file, fault);
    if (fault || !std::ifstream(file, std::ios::binary))
        return refuse("the file cannot be opened");
    if (bytes > largestSofaBytes)
        return refuse("it is larger than 256 MiB");
    const auto table = tableOf(file, sampleRateHz);
    if (!table)
        return refuse("reading it failed; it may be damaged");
    auto head = decodeSofaTable(*table);
    if (!head)
        return refuse(head.error().message);
    return head;
}

} // namespace idiophone
