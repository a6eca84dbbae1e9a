#include "Output/WavWriter.h"

#include "Object/FileBeside.h"
#include "Output/JuceFile.h"

#include <algorithm>
#include <cmath>
#include <juce_audio_formats/juce_audio_formats.h>
#include <vector>

namespace idiophone {

WavWriter::WavWriter(const std::filesystem::path& destination) : file(behindLinks(destination)) {}

WavWriter::~WavWriter() {
    if (partial.empty())
        return;
    writer.reset();
    std::error_code ignored;
    std::filesystem::remove(partial, ignored);
}

tl::unexpected<Error> WavWriter::fault() const {
    return failure(file.string() + ": the file cannot be written");
}

Result<std::unique_ptr<WavWriter>> WavWriter::create(const std::filesystem::path& file,
                                                     int sampleRateHz,
                                                     int channelCount,
                                                     int bitDepth) {
    std::unique_ptr<WavWriter> result(new WavWriter(file));
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        return failure(file.string() + ": it is a directory");
    if (std::filesystem::exists(result->file, ignored) &&
        !std::filesystem::is_regular_file(result->file, ignored))
        return failure(file.string() + ": a WAV file cannot be written to a device or a pipe");
    const auto beside = makeFileBeside(result->file);
    if (!beside)
        return result->fault();
    result->partial = *beside;
    auto stream = std::make_unique<juce::FileOutputStream>(juceFile(*beside));
    if (!stream->openedOk())
        return result->fault();
    result->writer.reset(juce::WavAudioFormat().createWriterFor(
        stream.get(), sampleRateHz, static_cast<unsigned>(channelCount), bitDepth, {}, 0));
    if (result->writer == nullptr)
        return result->fault();
    result->stream = stream.release(); // owned by the writer now
    return result;
}

Result<void> WavWriter::write(const float* const* channels, int sampleCount) {
    const bool written =
        writer->isFloatingPoint()
            ? writer->writeFromFloatArrays(channels, writer->getNumChannels(), sampleCount)
            : writeRounded(channels, sampleCount);
    if (!written)
        return fault();
    return {};
}

// Rounds the samples. JUCE would truncate the lower bits, which shifts all samples by half a step.
bool WavWriter::writeRounded(const float* const* channels, int sampleCount) {
    const int unusedBits = 32 - writer->getBitsPerSample();
    const double fullScale = std::ldexp(1.0, writer->getBitsPerSample() - 1);
    const auto count = static_cast<std::size_t>(sampleCount);
    const auto channelCount = static_cast<std::size_t>(writer->getNumChannels());
    std::vector<int> steps(channelCount * count);
    std::vector<const int*> starts;
    for (std::size_t channel = 0; channel < channelCount; ++channel) {
        auto* start = steps.data() + channel * count;
        std::transform(channels[channel], channels[channel] + sampleCount, start, [&](float x) {
            const double step = std::clamp(std::round(x * fullScale), -fullScale, fullScale - 1);
            return static_cast<int>(std::ldexp(step, unusedBits));
        });
        starts.push_back(start);
    }
    return writer->write(starts.data(), sampleCount);
}

Result<void> WavWriter::finish() {
    writer->flush(); // reports no error even if the last samples are lost
    const auto end = stream->getPosition();
    stream->flush();
    const bool isWritten = stream->getStatus().wasOk();
    writer.reset();
    std::error_code error;
    const bool complete = isWritten && std::filesystem::file_size(partial, error) ==
                                           static_cast<std::uintmax_t>(end + end % 2);
    if (!complete || !putInPlace(partial, file))
        return fault();
    partial.clear();
    return {};
}

} // namespace idiophone
