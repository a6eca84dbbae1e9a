#include "Console/WavReader.h"

#include "Object/FileBytes.h"

#include <algorithm>
#include <cstdint>
#include <juce_audio_formats/juce_audio_formats.h>
#include <memory>
#include <string>

namespace idiophone {
namespace {

constexpr double longestSeconds = 600;
constexpr std::uintmax_t largestFileBytes = std::uintmax_t{1} << 30;
constexpr unsigned maximumChannels = 64;
constexpr double lowestRateHz = 1000, highestRateHz = 1e6;

/// Hides all chunks from JUCE except the format and the samples. JUCE trusts the lengths of other
/// chunks and reads beyond the end of their texts. Returns false if a chunk is longer than the
/// file.
bool hideMetadata(std::string& file) {
    juce::MemoryInputStream stream(file.data(), file.size(), false);
    const auto fileEnd = stream.getTotalLength();
    const auto name = [](const char* text) {
        return static_cast<int>(juce::ByteOrder::littleEndianInt(text));
    };
    const auto kind = stream.readInt();
    const bool is64 = kind == name("RF64");
    auto end = std::uint64_t{8} + static_cast<std::uint32_t>(stream.readInt());
    if ((!is64 && kind != name("RIFF")) || stream.readInt() != name("WAVE"))
        return true; // not a WAV file
    std::int64_t dataLength = 0;
    if (is64) {
        stream.setPosition(20); // in "ds64", which comes first
        end = 8 + static_cast<std::uint64_t>(stream.readInt64());
        dataLength = stream.readInt64();
    }
    end = std::min(end, static_cast<std::uint64_t>(fileEnd));
    for (std::int64_t chunk = 12; static_cast<std::uint64_t>(chunk) < end;) {
        stream.setPosition(chunk);
        const int id = stream.readInt();
        std::int64_t length = static_cast<std::uint32_t>(stream.readInt());
        if (is64 && id == name("data") && dataLength > 0)
            length = dataLength;
        if (length > fileEnd - stream.getPosition())
            return false;
        if (id != name("fmt ") && id != name("data") && id != name("ds64"))
            std::copy_n("JUNK", std::min<std::int64_t>(4, fileEnd - chunk), file.data() + chunk);
        chunk = stream.getPosition() + length + (length & 1);
    }
    return true;
}

bool isWav(std::string_view bytes) {
    return (bytes.starts_with("RIFF") || bytes.starts_with("RF64")) &&
           bytes.substr(std::min<std::size_t>(8, bytes.size())).starts_with("WAVE");
}

/// Returns the fault of the header, or an empty text.
std::string faultOf(const juce::AudioFormatReader& reader, std::uintmax_t fileBytes) {
    if (reader.numChannels < 1 || reader.numChannels > maximumChannels)
        return "it has " + std::to_string(reader.numChannels) + " channels";
    if (!(reader.sampleRate >= lowestRateHz && reader.sampleRate <= highestRateHz))
        return "its sample rate is not 1 kHz to 1 MHz";
    const auto bits = reader.bitsPerSample;
    if (bits != 8 && bits != 16 && bits != 24 && bits != 32)
        return "its samples have " + std::to_string(bits) + " bits";
    const auto frameBytes = std::uintmax_t{reader.numChannels} * (bits / 8);
    const auto frames = static_cast<std::uintmax_t>(reader.lengthInSamples);
    if (reader.lengthInSamples < 0 || frameBytes == 0 || frames > fileBytes / frameBytes)
        return "it is shorter than its header says";
    if (static_cast<double>(reader.lengthInSamples) > longestSeconds * reader.sampleRate)
        return "it is longer than ten minutes";
    return {};
}

} // namespace

Result<MonoRecording> readWav(const std::filesystem::path& file) {
    const auto refuse = [&](const std::string& sentence) {
        return failure(file.string() + ": " + sentence);
    };
    auto bytes = readBytes(file, largestFileBytes);
    if (!bytes)
        return refuse(bytes.error().message);
    if (!hideMetadata(*bytes))
        return refuse("it is shorter than its header says");
    const std::unique_ptr<juce::AudioFormatReader> reader(juce::WavAudioFormat().createReaderFor(
        new juce::MemoryInputStream(bytes->data(), bytes->size(), false), true));
    if (reader == nullptr)
        return refuse(isWav({bytes->data(), bytes->size()})
                          ? "its samples are neither integers of 8 to 32 bits nor 32-bit floats"
                          : "it is not a WAV file");
    if (const auto sentence = faultOf(*reader, bytes->size()); !sentence.empty())
        return refuse(sentence);

    const auto channelCount = static_cast<int>(reader->numChannels);
    const auto length = static_cast<int>(reader->lengthInSamples);
    constexpr int pieceLength = 1 << 14;
    juce::AudioBuffer<float> piece(channelCount, pieceLength);
    MonoRecording result{std::vector<float>(static_cast<std::size_t>(length)), reader->sampleRate};
    for (int begin = 0; begin < length; begin += pieceLength) {
        const int count = std::min(pieceLength, length - begin);
        if (!reader->read(piece.getArrayOfWritePointers(), channelCount, begin, count))
            return refuse("the file cannot be read");
        for (int channel = 0; channel < channelCount; ++channel)
            for (int i = 0; i < count; ++i)
                result.samples[static_cast<std::size_t>(begin + i)] +=
                    piece.getSample(channel, i) / static_cast<float>(channelCount);
    }
    return result;
}

} // namespace idiophone
