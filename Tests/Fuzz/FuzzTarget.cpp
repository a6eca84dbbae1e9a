#include "Fuzz/FuzzTarget.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace idiophone::fuzz {
namespace {

namespace fs = std::filesystem;

/// A folder that is removed at the end of the process, unless the process crashes.
class ScratchFolder {
public:
    ScratchFolder() {
        std::error_code ignored;
        const fs::path memory = "/dev/shm";
        path = (fs::is_directory(memory, ignored) ? memory : fs::temp_directory_path()) /
               ("idiophone-fuzz-" + std::to_string(getpid()));
        fs::create_directories(path);
    }
    ~ScratchFolder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    fs::path path;
};

bool isUtf8(const std::string& text) {
    try {
        return !nlohmann::json(text).dump().empty();
    } catch (const nlohmann::json::exception&) {
        return false;
    }
}

} // namespace

void claim(bool holds, std::string_view text) {
    if (holds)
        return;
    std::fprintf(stderr, "This does not hold: %.*s\n", static_cast<int>(text.size()), text.data());
    std::abort();
}

void claimSentence(const Error& error) {
    constexpr std::size_t longest = 600;
    const auto& text = error.message;
    claim(text.size() > 10, "an error is a sentence");
    claim(text.size() <= longest, "an error is short: " + text.substr(0, longest));
    claim(std::ranges::none_of(text, [](unsigned char c) { return c < ' ' || c == 127; }),
          "an error is free of control characters: " + text);
    claim(isUtf8(text), "an error is UTF-8: " + text);
}

fs::path scratchFile(std::string_view bytes, const std::string& name) {
    static const ScratchFolder folder;
    const auto file = folder.path / name;
    std::ofstream stream(file, std::ios::binary | std::ios::trunc);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    claim(static_cast<bool>(stream), "the scratch file could be written");
    return file;
}

} // namespace idiophone::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    idiophone::fuzz::examine({reinterpret_cast<const char*>(bytes), size});
    return 0;
}
