// The user's preset files: a folder with folders in it. It reads, writes and moves files; what
// plays is no business of it.
#pragma once

#include "Instrument/Preset.h"

#include <cstdint>
#include <juce_core/juce_core.h>
#include <map>
#include <vector>

namespace idiophone {

/// For the message thread. Errors are one sentence; where there is one, no file has changed.
class PresetFolder {
public:
    struct Entry {
        std::string id;     ///< path below the folder, with '/': "Bells/Small bell.json"
        std::string folder; ///< "Bells"
        Result<Preset> preset;
        std::uint64_t content = 0; ///< hash of the file as it was read
    };

    static constexpr int deepestFolder = 4; ///< deeper ones are not looked at

    /// An empty file is a folder that this machine has no place for. No more than `mostEntries`
    /// files and folders of any kind are looked at, and what links lead to last, and once.
    explicit PresetFolder(juce::File folder, int mostEntries = 20'000)
        : root(std::move(folder)), entryLimit(mostEntries) {}

    /// By folder and name, whatever the case. Files that are as they were are not read again.
    const std::vector<Entry>& read();
    const Entry* find(const std::string& id) const;

    juce::File fileOf(const std::string& id) const;
    /// Where a preset of that name in that folder is saved; an error where there is no such place.
    Result<juce::File> placeFor(const std::string& name, const std::string& folder) const;
    /// Hash of what is in the file now; 0 where it cannot be read.
    static std::uint64_t contentOf(const juce::File& file);
    /// An error where the preset's file is not there any more, or not with that content: another
    /// window or program has moved or written it. The sentence says what to do.
    Result<void> checkContent(const std::string& id, std::uint64_t content);

    /// Through a file beside it, so that what is there is never half overwritten. Returns the id.
    Result<std::string> write(const Preset& preset, const std::string& folder, bool replace);
    /// Writes over the preset's file, whatever it is called.
    Result<void> replace(const std::string& id, const Preset& preset);
    /// Writes the file's preset under another name, in the file and of it. Returns the new id.
    Result<std::string> rename(const std::string& id, const std::string& name);
    Result<void> moveToBin(const std::string& id);

    /// The folder, made if it was not there.
    Result<juce::File> folder() const;

private:
    struct Known {
        juce::int64 bytes = 0;
        juce::Time written;
        Result<Preset> preset;
        std::uint64_t content = 0;
    };

    static Known readKnown(const juce::File& file);
    std::string idOf(const juce::File& file) const;

    juce::File root;
    int entryLimit;
    std::map<std::string, Known> known;
    std::vector<Entry> found;
};

} // namespace idiophone
