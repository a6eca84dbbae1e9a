#include "Console/SofaHead.h"

#include "Console/SofaTable.h"
#include "Object/TextFile.h"

#include <juce_core/juce_core.h>
#include <optional>
#include <string>

namespace idiophone {
namespace {

// Of the clock: some more than it may have of a processor.
constexpr int patienceMilliseconds = 1000 * (2 * sofaPatienceSeconds);

/// The other process's table, or nothing where it came to no end by itself. (A process that a
/// signal ended has no exit code of its own in juce::ChildProcess: the table is what counts.)
std::optional<std::string> tableOf(const std::filesystem::path& file, int sampleRateHz) {
    const juce::TemporaryFile table(".table");
    const auto self = juce::File::getSpecialLocation(juce::File::currentExecutableFile);
    const auto path = std::filesystem::absolute(file); // also no option
    juce::ChildProcess reader;
    if (!reader.start({self.getFullPathName(), "sofa-table", juce::String(path.string()),
                       juce::String(sampleRateHz), table.getFile().getFullPathName()},
                      0))
        return std::nullopt;
    if (!reader.waitForProcessToFinish(patienceMilliseconds))
        reader.kill();
    auto read = readTextFile(table.getFile().getFullPathName().toStdString());
    if (!read)
        return std::nullopt;
    return std::move(*read);
}

} // namespace

Result<std::shared_ptr<const HeadResponses>> readSofaHead(const std::filesystem::path& file,
                                                          int sampleRateHz) {
    if (auto readable = readTextFile(file, largestSofaBytes); !readable)
        return tl::unexpected(readable.error());
    const auto refuse = [&](const std::string& sentence) {
        return failure(file.string() + ": " + sentence);
    };
    const auto table = tableOf(file, sampleRateHz);
    if (!table)
        return refuse("reading it failed; it may be damaged");
    auto head = decodeSofaTable(*table);
    if (!head)
        return refuse(head.error().message);
    return head;
}

} // namespace idiophone
