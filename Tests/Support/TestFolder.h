// Makes a folder for a test's files that no other running test shares.
#pragma once

#include <filesystem>
#include <random>
#include <string>

namespace idiophone::test {

/// Returns this process's own folder, removed when the process ends. CTest runs several test cases
/// at a time, each as a process, so they cannot share a fixed name.
inline const std::filesystem::path& testFolder() {
    struct Folder {
        Folder() { std::filesystem::create_directories(path); }
        ~Folder() {
            std::error_code ignored;
            std::filesystem::remove_all(path, ignored);
        }
        const std::filesystem::path path = std::filesystem::path(IDIOPHONE_TEST_DIR) /
                                           ("files-" + std::to_string(std::random_device{}()) +
                                            std::to_string(std::random_device{}()));
    };
    static const Folder folder;
    return folder.path;
}

/// Returns a folder of that name in `testFolder`, without the files of an earlier call.
inline std::filesystem::path emptyFolder(const std::string& name) {
    const auto folder = testFolder() / name;
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

} // namespace idiophone::test
