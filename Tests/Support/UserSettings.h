// Replaces this user's settings folder by an empty one, while the object lives.
#pragma once

#include "Object/MaterialFile.h"
#include "Support/TestFolder.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace idiophone::test {

/// Construct it before the processors that must see it.
class UserSettings {
public:
    UserSettings() {
        std::filesystem::remove_all(root);
        setSettings(root.string().c_str());
        std::filesystem::create_directories(folder());
    }
    UserSettings(const UserSettings&) = delete;
    UserSettings& operator=(const UserSettings&) = delete;
    ~UserSettings() { setSettings(before.c_str()); }

    /// Returns Idiophone's settings folder.
    std::filesystem::path folder() const { return userMaterialFolder().parent_path(); }

    void write(const std::filesystem::path& name, const std::string& text) const {
        const auto file = folder() / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
    }

    std::string read(const std::filesystem::path& name) const {
        std::ifstream file(folder() / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

private:
#if defined(_WIN32)
    static constexpr const char* variable = "APPDATA";
    static void setSettings(const char* value) {
        _putenv_s(variable, value);
    }
#elif defined(__APPLE__)
    static constexpr const char* variable = "HOME";
    static void setSettings(const char* value) {
        setenv(variable, value, 1);
    }
#else
    static constexpr const char* variable = "XDG_CONFIG_HOME";
    static void setSettings(const char* value) {
        setenv(variable, value, 1);
    }
#endif
    const std::filesystem::path root = testFolder() / "settings";
    const std::string before = std::getenv(variable) != nullptr ? std::getenv(variable) : "";
};

} // namespace idiophone::test
