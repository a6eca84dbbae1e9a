// Finds a place for files that are dragged out of the window.
#pragma once

#include "Editor/Utf8.h"

#include <chrono>
#include <filesystem>
#include <juce_core/juce_core.h>
#include <vector>

namespace idiophone {

/// For the message thread. Each process has its own folder in the system's temporary one, because
/// several users may share that one. Hosts may still read dropped files after the process ends, so
/// other processes remove the folder a week after its last file.
class DragFolder {
public:
    /// Returns the folder, or an empty File if it cannot be made. Makes it again if somebody
    /// deleted it.
    static juce::File get() {
        static juce::File folder;
        if (folder.isDirectory())
            return folder;
        removeOld();
        const auto next = temporaryFolder().getChildFile(
            prefix + juce::String::toHexString(juce::Random().nextInt64()));
        std::error_code fault;
        // If the folder existed before, another user may own it.
        if (std::filesystem::create_directory(pathOf(next), fault)) {
            std::filesystem::permissions(pathOf(next), std::filesystem::perms::owner_all, fault);
            folder = next;
        }
        return folder;
    }

    /// Returns whether any window wrote this file for a drag.
    static bool contains(const std::filesystem::path& file) {
        const auto folder = file.parent_path();
        return folder.parent_path() == pathOf(temporaryFolder()) &&
               nameOf(folder).startsWith(prefix);
    }

    /// Removes the folders of this user to which nothing was added for a week.
    static void removeOld() {
        using namespace std::chrono_literals;
        std::error_code fault;
        const auto oldest = std::filesystem::file_time_type::clock::now() - 168h;
        std::vector<std::filesystem::path> old;
        for (auto each = std::filesystem::directory_iterator(pathOf(temporaryFolder()), fault);
             !fault && each != std::filesystem::directory_iterator(); each.increment(fault))
            if (std::error_code unknown; nameOf(each->path()).startsWith(prefix) &&
                                         each->last_write_time(unknown) < oldest && !unknown)
                old.push_back(each->path());
        for (const auto& folder : old)
            std::filesystem::remove_all(folder, fault);
    }

private:
    static constexpr const char* prefix = "Idiophone-drag-";

    static juce::String nameOf(const std::filesystem::path& file) {
        return textOf(file.filename());
    }
    static juce::File temporaryFolder() {
        return juce::File::getSpecialLocation(juce::File::tempDirectory);
    }
};

} // namespace idiophone
