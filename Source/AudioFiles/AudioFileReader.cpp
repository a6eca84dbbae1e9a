#include "AudioFiles/AudioFileReader.h"

#include "Object/FileBytes.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <sndfile.h>
#include <span>
#include <string>
#include <string_view>

namespace idiophone {
namespace {

constexpr double longestSeconds = 600;
constexpr std::uintmax_t largestFileBytes = std::uintmax_t{1} << 30;
constexpr int maximumChannels = 64;
constexpr double lowestRateHz = 1000, highestRateHz = 1e6;
constexpr sf_count_t pieceFrames = 1 << 12;
constexpr auto tooLong = "it is longer than ten minutes";
constexpr auto tooShort = "it is shorter than its header says";

/// The file in memory, for libsndfile.
struct MemoryFile {
    std::string_view bytes;
    sf_count_t position = 0;

    sf_count_t length() const { return static_cast<sf_count_t>(bytes.size()); }
};

MemoryFile& memoryFile(void* file) {
    return *static_cast<MemoryFile*>(file);
}

sf_count_t lengthOf(void* file) {
    return memoryFile(file).length();
}

sf_count_t seek(sf_count_t offset, int origin, void* file) {
    auto& memory = memoryFile(file);
    if (origin == SEEK_CUR)
        offset += memory.position;
    if (origin == SEEK_END)
        offset += memory.length();
    return memory.position = std::clamp<sf_count_t>(offset, 0, memory.length());
}

sf_count_t read(void* target, sf_count_t count, void* file) {
    auto& memory = memoryFile(file);
    count = std::clamp<sf_count_t>(count, 0, memory.length() - memory.position);
    std::copy_n(memory.bytes.data() + memory.position, count, static_cast<char*>(target));
    memory.position += count;
    return count;
}

sf_count_t position(void* file) {
    return memoryFile(file).position;
}

/// Returns the name of the file's format, or nothing if it is none that is read.
std::optional<std::string> formatOf(std::string_view bytes) {
    const auto kind = bytes.substr(0, 4),
               form = bytes.substr(std::min<std::size_t>(8, bytes.size()), 4);
    if ((kind == "RIFF" || kind == "RF64") && form == "WAVE")
        return "WAV";
    if (kind == "FORM" && (form == "AIFF" || form == "AIFC"))
        return "AIFF";
    if (kind == "fLaC")
        return "FLAC";
    return std::nullopt;
}

/// Returns a number whose lowest byte comes first, 0 beyond the end.
std::uint64_t numberAt(std::string_view bytes, std::size_t at, std::size_t size) {
    std::uint64_t number = 0;
    if (at + size <= bytes.size())
        for (std::size_t i = size; i-- > 0;)
            number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
    return number;
}

/// A program that writes to a pipe cannot return to the header. It leaves 0 there, or one of the
/// highest numbers.
bool isUnknown(std::uint64_t length) {
    return length == 0 || length >= 0x7fff0000;
}

/// Lets samples of unknown length reach to the end of the file. Returns false if the file ends
/// before the known end of its samples.
bool settleLength(std::string& wav) {
    const bool is64 = wav.starts_with("RF64");
    constexpr std::size_t dataLength64 = 28; // in "ds64", which comes first
    const bool isOpen = is64 || isUnknown(numberAt(wav, 4, 4));
    for (std::size_t chunk = 12; chunk + 8 <= wav.size();) {
        const std::uint64_t rest = wav.size() - chunk - 8;
        auto length = numberAt(wav, chunk + 4, 4);
        if (wav.compare(chunk, 4, "data") == 0) {
            if (is64)
                length = numberAt(wav, dataLength64, 8);
            if (length <= rest && !(length == 0 && isOpen))
                return true;
            if (!isUnknown(length))
                return false;
            wav.replace(0, 4, "RIFF");
            wav.replace(chunk + 4, 4, 4, '\xff');
            return true;
        }
        chunk += 8 + length + (length & 1);
    }
    return true; // libsndfile says that it has no samples
}

/// Returns false if the file ends before the known end of its last chunk.
bool reachesEnd(std::string_view aiff) {
    std::string length(aiff.substr(4, 4)); // its highest byte comes first
    std::ranges::reverse(length);
    return isUnknown(numberAt(length, 0, 4)) || numberAt(length, 0, 4) <= aiff.size() - 8;
}

/// Returns libsndfile's words for the last fault as a part of a sentence.
std::string lastFault() {
    std::string words = sf_strerror(nullptr);
    while (words.ends_with('.') || words.ends_with('\n'))
        words.pop_back();
    const auto lastSentence = words.rfind(". ");
    return lastSentence == std::string::npos ? words : words.substr(lastSentence + 2);
}

/// Returns the fault of the header, or an empty text.
std::string faultOf(const SF_INFO& info) {
    if (info.channels < 1 || info.channels > maximumChannels)
        return "it has " + std::to_string(info.channels) + " channels";
    if (!(info.samplerate >= lowestRateHz && info.samplerate <= highestRateHz))
        return "its sample rate is not 1 kHz to 1 MHz";
    const bool isKnown = info.frames != SF_COUNT_MAX;
    if (isKnown && static_cast<double>(info.frames) > longestSeconds * info.samplerate)
        return tooLong;
    return {};
}

/// Takes the frames of a piece, interleaved.
using TakePiece = std::function<void(std::span<const float> frames, const SF_INFO& info)>;

/// Reads all samples. The error is the end of a sentence that begins with the file's name.
Result<void> readSamples(SNDFILE* file, const SF_INFO& info, const TakePiece& take) {
    const auto channels = static_cast<std::size_t>(info.channels);
    std::vector<float> piece(static_cast<std::size_t>(pieceFrames) * channels);
    take({}, info); // a file without samples has a rate, too
    sf_count_t frames = 0;
    for (sf_count_t count; (count = sf_readf_float(file, piece.data(), pieceFrames)) > 0;) {
        take(std::span(piece).first(static_cast<std::size_t>(count) * channels), info);
        frames += count;
        if (static_cast<double>(frames) > longestSeconds * info.samplerate)
            return failure(tooLong);
    }
    if (info.frames != SF_COUNT_MAX && frames < info.frames)
        return failure(tooShort);
    if (sf_error(file) != SF_ERR_NO_ERROR)
        return failure("its samples are damaged");
    return {};
}

Result<void> readFile(const std::filesystem::path& file, const TakePiece& take) {
    const auto refuse = [&](const std::string& sentence) {
        return failure(nameOf(file) + ": " + sentence);
    };
    auto bytes = readBytes(file, largestFileBytes);
    if (!bytes)
        return refuse(bytes.error().message);
    const auto format = formatOf(*bytes);
    if (!format)
        return refuse("it is not a WAV, FLAC or AIFF file");
    if ((*format == "WAV" && !settleLength(*bytes)) || (*format == "AIFF" && !reachesEnd(*bytes)))
        return refuse(tooShort);
    MemoryFile memory{.bytes = *bytes};
    SF_VIRTUAL_IO access{lengthOf, seek, read, nullptr, position};
    SF_INFO info{};
    const std::unique_ptr<SNDFILE, decltype(&sf_close)> opened(
        sf_open_virtual(&access, SFM_READ, &info, &memory), sf_close);
    if (opened == nullptr)
        return refuse("it is damaged, or of a kind of " + *format + " that cannot be read (" +
                      lastFault() + ")");
    if (const auto sentence = faultOf(info); !sentence.empty())
        return refuse(sentence);
    try {
        const auto done = readSamples(opened.get(), info, take);
        return done ? done : refuse(done.error().message);
    } catch (const std::bad_alloc&) {
        return refuse("it is too large for this machine's memory");
    }
}

} // namespace

Result<MonoRecording> readRecording(const std::filesystem::path& file) {
    MonoRecording result;
    const auto mix = [&](std::span<const float> frames, const SF_INFO& info) {
        result.sampleRateHz = info.samplerate;
        const auto channels = static_cast<std::size_t>(info.channels);
        for (; !frames.empty(); frames = frames.subspan(channels)) {
            float mean = 0;
            for (const float sample : frames.first(channels))
                mean += sample / static_cast<float>(channels);
            result.samples.push_back(mean);
        }
    };
    return readFile(file, mix).map([&] { return std::move(result); });
}

Result<InterleavedRecording> readChannels(const std::filesystem::path& file) {
    InterleavedRecording result;
    const auto append = [&](std::span<const float> frames, const SF_INFO& info) {
        result.sampleRateHz = info.samplerate;
        result.channelCount = info.channels;
        result.samples.insert(result.samples.end(), frames.begin(), frames.end());
    };
    return readFile(file, append).map([&] { return std::move(result); });
}

} // namespace idiophone
