// Replaces this user's home folder by an empty one, while the object lives. Not for Windows, where
// no variable moves the user's folders.
#pragma once

#ifndef _WIN32

#include "Support/TestFolder.h"

#include <cstdlib>
#include <filesystem>
#include <string>

namespace idiophone::test {

/// On macOS JUCE asks CoreFoundation, which does not read HOME.
inline void setHome(const std::string& folder) {
    setenv("HOME", folder.c_str(), 1);
#ifdef __APPLE__
    setenv("CFFIXED_USER_HOME", folder.c_str(), 1);
#endif
}

class HomeFolder {
public:
    HomeFolder() {
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
        setHome(folder.string());
    }
    HomeFolder(const HomeFolder&) = delete;
    HomeFolder& operator=(const HomeFolder&) = delete;
    ~HomeFolder() { setHome(before); }

    /// Returns the folder of the recordings.
    std::filesystem::path music() const { return folder / "Music" / "Idiophone"; }

private:
    const std::filesystem::path folder = testFolder() / "home";
    const std::string before = std::getenv("HOME") != nullptr ? std::getenv("HOME") : "";
};

} // namespace idiophone::test

#endif
