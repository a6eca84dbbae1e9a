// Reads, writes and moves the user's preset files, in a folder with subfolders. It does not know
// the playing sound.
#pragma once

#include "Instrument/Preset.h"

#include <cstdint>
#include <juce_core/juce_core.h>
#include <vector>

namespace idiophone {

/// For the message thread. An error is one sentence, and then no file has changed.
class PresetFolder {
public:
    struct Entry {
        std::string id;     ///< path below the folder, with '/': "Bells/Small bell.json"
        std::string folder; ///< "Bells"
        Result<Preset> preset;
        std::uint64_t content = 0; ///< hash of the file when it was read
        juce::int64 bytes = 0;     ///< size of the file when it was read; −1 after `forget`
        juce::Time written = {};   ///< when it was written
    };

    static constexpr int deepestFolder = 4; ///< deeper folders are ignored

    /// An empty file means that this machine has no preset folder. Visits at most `maximumEntries`
    /// files and folders of any kind. Follows links last, and each target once.
    explicit PresetFolder(juce::File folder, int maximumEntries = 20'000)
        : root(std::move(folder)), entryLimit(maximumEntries) {}

    /// Returns the presets sorted by folder and name, ignoring case. Does not read unchanged files
    /// again.
    const std::vector<Entry>& read();
    const Entry* find(const std::string& id) const;

    juce::File fileOf(const std::string& id) const;
    /// Returns the file for a preset of that name in that folder, or an error if the name or folder
    /// cannot be used.
    Result<juce::File> placeFor(const std::string& name, const std::string& folder) const;
    /// Returns the hash of the file's present content, or 0 if it cannot be read.
    static std::uint64_t contentOf(const juce::File& file);
    /// Returns an error if the preset's file is missing or has other content, because another
    /// window or program changed it. The sentence says what to do.
    Result<void> checkContent(const std::string& id, std::uint64_t content);

    /// Writes a file beside it first, so that an existing file is never half overwritten. Returns
    /// the id.
    Result<std::string> write(const Preset& preset, const std::string& folder, bool replace);
    /// Overwrites the preset's file and keeps its file name.
    Result<void> replace(const std::string& id, const Preset& preset);
    /// Renames the preset, both in the file and the file itself. Returns the new id.
    Result<std::string> rename(const std::string& id, const std::string& name);
    Result<void> moveToBin(const std::string& id);

    /// Returns the folder, and makes it if needed.
    Result<juce::File> folder() const;

private:
    Entry readEntry(const juce::File& file) const;
    /// Makes the next `read` read this file: file times are coarse.
    void forget(const std::string& id);
    std::string idOf(const juce::File& file) const;

    juce::File root;
    int entryLimit;
    std::vector<Entry> found;
};

} // namespace idiophone
