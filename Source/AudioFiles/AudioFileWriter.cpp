#include "AudioFiles/AudioFileWriter.h"

#include "Object/FileBeside.h"
#include "Object/FileBytes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <sndfile.h>

namespace idiophone {
namespace {

constexpr std::size_t pieceFrames = 1 << 12;

std::ofstream& streamOf(void* stream) {
    return *static_cast<std::ofstream*>(stream);
}

sf_count_t position(void* stream) {
    const auto here = streamOf(stream).tellp();
    if (here < 0) // libc++ writes what it holds, and would forget that it could not
        streamOf(stream).setstate(std::ios::badbit);
    return static_cast<sf_count_t>(here);
}

sf_count_t seek(sf_count_t offset, int origin, void* stream) {
    streamOf(stream).seekp(offset, origin == SEEK_SET   ? std::ios::beg
                                   : origin == SEEK_CUR ? std::ios::cur
                                                        : std::ios::end);
    return position(stream);
}

sf_count_t lengthOf(void* stream) {
    const auto here = position(stream);
    const auto length = seek(0, SEEK_END, stream);
    seek(here, SEEK_SET, stream);
    return length;
}

sf_count_t append(const void* bytes, sf_count_t count, void* stream) {
    streamOf(stream).write(static_cast<const char*>(bytes), count);
    return streamOf(stream).good() ? count : 0;
}

bool isFlac(const std::filesystem::path& file) {
    return file.extension() == ".flac";
}

/// Floats go into a file without a limit of 4 GB (RF64), which turns into a plain WAV file if it
/// stays below. Whole numbers go into a plain one, which more programs read.
int formatFor(const std::filesystem::path& file, int bitDepth) {
    if (bitDepth == 32)
        return SF_FORMAT_RF64 | SF_FORMAT_FLOAT;
    return (isFlac(file) ? SF_FORMAT_FLAC : SF_FORMAT_WAV) |
           (bitDepth == 16 ? SF_FORMAT_PCM_16 : SF_FORMAT_PCM_24);
}

} // namespace

/// The file being written.
struct AudioFileWriter::Target {
    explicit Target(const std::filesystem::path& file) : stream(file, std::ios::binary) {}

    std::ofstream stream;
    std::unique_ptr<SNDFILE, decltype(&sf_close)> sound{nullptr, sf_close};
    bool isWav = false; ///< one that ends at 4 GB
};

AudioFileWriter::AudioFileWriter(const std::filesystem::path& destination, int channels, int bits)
    : file(behindLinks(destination)), channelCount(static_cast<std::size_t>(channels)),
      bitDepth(bits) {}

AudioFileWriter::~AudioFileWriter() {
    if (partial.empty())
        return;
    target.reset();
    std::error_code ignored;
    std::filesystem::remove(partial, ignored);
}

tl::unexpected<Error> AudioFileWriter::fault() const {
    return failure(nameOf(file) + ": the file cannot be written");
}

int AudioFileWriter::usualBitDepth(const std::filesystem::path& file) {
    return isFlac(file) ? 24 : 32;
}

Result<std::unique_ptr<AudioFileWriter>> AudioFileWriter::create(const std::filesystem::path& file,
                                                                 int sampleRateHz,
                                                                 int channelCount,
                                                                 int bitDepth) {
    std::unique_ptr<AudioFileWriter> result(new AudioFileWriter(file, channelCount, bitDepth));
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        return failure(nameOf(file) + ": it is a directory");
    if (std::filesystem::exists(result->file, ignored) &&
        !std::filesystem::is_regular_file(result->file, ignored))
        return failure(nameOf(file) + ": an audio file cannot be written to a device or a pipe");
    if (isFlac(file) && bitDepth == 32)
        return failure(nameOf(file) + ": a FLAC file has 16 or 24 bits, not 32");
    const auto beside = makeFileBeside(result->file);
    if (!beside)
        return result->fault();
    result->partial = *beside;
    result->target = std::make_unique<Target>(*beside);
    auto& target = *result->target;
    SF_INFO info{};
    info.samplerate = sampleRateHz;
    info.channels = channelCount;
    info.format = formatFor(file, bitDepth);
    if (!target.stream.is_open() || sf_format_check(&info) == SF_FALSE)
        return result->fault();
    SF_VIRTUAL_IO access{lengthOf, seek, nullptr, append, position};
    target.sound.reset(sf_open_virtual(&access, SFM_WRITE, &info, &target.stream));
    if (target.sound == nullptr)
        return result->fault();
    target.isWav = (info.format & SF_FORMAT_TYPEMASK) == SF_FORMAT_WAV;
    sf_command(target.sound.get(), SFC_RF64_AUTO_DOWNGRADE, nullptr, SF_TRUE);
    return result;
}

Result<void> AudioFileWriter::write(const float* const* channels, int sampleCount) {
    const auto count = static_cast<std::size_t>(sampleCount);
    for (std::size_t done = 0; done < count; done += pieceFrames)
        if (!writePiece(channels, done, std::min(pieceFrames, count - done)))
            return fault();
    constexpr std::int64_t largestWavBytes = 0xffff0000; // its header counts in 32 bits
    if (target->isWav && position(&target->stream) > largestWavBytes)
        return failure(nameOf(file) + ": a WAV file of whole numbers ends at 4 GB; use 32 bits");
    return {};
}

bool AudioFileWriter::writePiece(const float* const* channels,
                                 std::size_t begin,
                                 std::size_t count) {
    floats.resize(count * channelCount);
    for (std::size_t channel = 0; channel < channelCount; ++channel)
        for (std::size_t i = 0; i < count; ++i)
            floats[i * channelCount + channel] = channels[channel][begin + i];
    const auto frames = static_cast<sf_count_t>(count);
    if (bitDepth == 32)
        return sf_writef_float(target->sound.get(), floats.data(), frames) == frames;
    // libsndfile would truncate the lower bits, which shifts all samples by half a step.
    const double fullScale = std::ldexp(1.0, bitDepth - 1);
    steps.resize(floats.size());
    std::ranges::transform(floats, steps.begin(), [&](float x) {
        const double step = std::clamp(std::round(x * fullScale), -fullScale, fullScale - 1);
        return static_cast<int>(std::ldexp(step, 32 - bitDepth));
    });
    return sf_writef_int(target->sound.get(), steps.data(), frames) == frames;
}

Result<void> AudioFileWriter::finish() {
    const bool isClosed = sf_close(target->sound.release()) == 0;
    target->stream.close(); // a failed write anywhere before is remembered
    if (!isClosed || target->stream.fail() || !putInPlace(partial, file))
        return fault();
    partial.clear();
    return {};
}

} // namespace idiophone
