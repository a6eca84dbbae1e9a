#include "Console/Recording.h"

#include "Console/Interrupt.h"
#include "Console/OptionChecks.h"
#include "Object/FileBytes.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace idiophone {

using nlohmann::ordered_json;

namespace {

double decibelsFullScale(double amplitude) {
    return 20 * std::log10(amplitude);
}

int bitDepthOf(const RecordingFormat& format) {
    return format.bitDepth.value_or(AudioFileWriter::usualBitDepth(format.file));
}

} // namespace

void addRecordingOptions(CLI::App& command, RecordingFormat& format) {
    command.add_option("-o,--output", format.file, "The WAV or FLAC file to write")
        ->type_name(writtenFile)
        ->required();
    command.add_option("--sample-rate", format.sampleRateHz, "Sample rate in Hz")
        ->check(numberBetween(8000, 384000))
        ->capture_default_str();
    command.add_option("--block-size", format.blockSize, "Samples rendered at a time")
        ->check(numberBetween(1, 8192))
        ->capture_default_str();
    command
        .add_option("--bit-depth", format.bitDepth,
                    "16, 24, or 32 (floating point, WAV only). Default: 32, for FLAC 24")
        ->check(CLI::IsMember({16, 24, 32}));
    command.add_option("--seconds", format.seconds, "Length of the file (default: until silence)")
        ->check(numberBetween(0.001, 36000));
}

Recording::Recording(RecordingFormat wanted, const ParameterValues& values)
    : format(std::move(wanted)), parameters(values), meter(2, format.sampleRateHz) {
    const auto size = static_cast<std::size_t>(format.blockSize);
    writtenLeft.resize(size);
    writtenRight.resize(size);
    interleaved.resize(2 * size);
    output.prepare(format.sampleRateHz, format.blockSize);
}

Recording::~Recording() = default;

Result<std::unique_ptr<Recording>> Recording::start(const RecordingFormat& format,
                                                    const ParameterValues& parameters) {
    interruptRequested(); // installs the handler, so that an interrupt leaves no partial file
    std::unique_ptr<Recording> result(new Recording(format, parameters));
    auto writer = AudioFileWriter::create(format.file, format.sampleRateHz, 2, bitDepthOf(format));
    if (!writer)
        return tl::unexpected(writer.error());
    result->writer = std::move(*writer);
    return result;
}

Result<void> Recording::add(std::span<const float> left, std::span<const float> right) {
    float* channels[] = {writtenLeft.data(), writtenRight.data()};
    if (!output.process(left, right, channels, parameters))
        return failure(nameOf(format.file) + ": the sound is not finite, so it is not written");
    auto sounding = static_cast<int>(left.size());
    while (sounding > 0 && writtenLeft[static_cast<std::size_t>(sounding - 1)] == 0 &&
           writtenRight[static_cast<std::size_t>(sounding - 1)] == 0)
        --sounding;
    if (sounding > 0) {
        // Keep the output stage's block: write the silence from the meter's buffer.
        if (auto done = writeSilence(heldBack); !done)
            return done;
        heldBack = 0;
        if (auto done = write(sounding); !done)
            return done;
    }
    heldBack += static_cast<std::int64_t>(left.size()) - sounding;
    return {};
}

Result<void> Recording::addAll(std::span<const float> left, std::span<const float> right) {
    const auto blockSize = static_cast<std::size_t>(format.blockSize);
    for (std::size_t done = 0; done < left.size(); done += blockSize) {
        const auto count = std::min(blockSize, left.size() - done);
        if (auto added = add(left.subspan(done, count), right.subspan(done, count)); !added)
            return added;
    }
    return {};
}

Result<void> Recording::writeSilence(std::int64_t samples) {
    std::fill(interleaved.begin(), interleaved.end(), 0.0f);
    const float* channels[] = {interleaved.data(), interleaved.data()};
    while (samples > 0) {
        const auto count = static_cast<int>(std::min<std::int64_t>(samples, format.blockSize));
        if (auto done = writer->write(channels, count); !done)
            return done;
        meter.add(std::span(interleaved).first(2 * static_cast<std::size_t>(count)));
        written += count;
        samples -= count;
    }
    return {};
}

Result<void> Recording::write(int samples) {
    const float* channels[] = {writtenLeft.data(), writtenRight.data()};
    if (auto done = writer->write(channels, samples); !done)
        return done;
    for (std::size_t i = 0; i < static_cast<std::size_t>(samples); ++i) {
        interleaved[2 * i] = writtenLeft[i];
        interleaved[2 * i + 1] = writtenRight[i];
        highest = std::max<double>(
            {highest, std::abs(interleaved[2 * i]), std::abs(interleaved[2 * i + 1])});
    }
    meter.add(std::span(interleaved).first(2 * static_cast<std::size_t>(samples)));
    written += samples;
    return {};
}

Result<void> Recording::finish(std::int64_t minimumSamples) {
    if (auto done = writeSilence(std::clamp<std::int64_t>(minimumSamples - written, 0, heldBack));
        !done)
        return done;
    if (auto done = writer->finish(); !done)
        return done;
    if (highest > 1)
        warnOfPeak();
    return {};
}

void Recording::warnOfPeak() const {
    const double peakDb = decibelsFullScale(highest);
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << nameOf(format.file) << ": its peak of " << peakDb
         << " dBFS is "
         << (bitDepthOf(format) == 32 ? "above full scale and clips in playback"
                                      : "clipped; use --bit-depth 32");
    const auto& level = parameterInfo(ParameterId::level);
    const double lower = std::floor(10 * (parameters[level.parameter] - peakDb)) / 10;
    if (lower >= level.minimum)
        text << "; --set level=" << lower << " avoids this";
    std::cerr << "warning: " << text.str() << std::endl;
}

ordered_json Recording::statistics() const {
    const auto loudness = meter.integratedLufs();
    return {{"samples", written},
            {"seconds", static_cast<double>(written) / format.sampleRateHz},
            {"sample_rate_hz", format.sampleRateHz},
            {"peak_dbfs", highest > 0 ? ordered_json(decibelsFullScale(highest)) : nullptr},
            {"integrated_lufs", loudness ? ordered_json(*loudness) : nullptr}};
}

std::string Recording::summary() const {
    std::ostringstream text;
    text << std::fixed << std::setprecision(2) << static_cast<double>(written) / format.sampleRateHz
         << " s at " << format.sampleRateHz << " Hz, ";
    if (highest > 0)
        text << "peak " << std::setprecision(1) << decibelsFullScale(highest) << " dBFS";
    else
        text << "silent";
    if (const auto loudness = meter.integratedLufs())
        text << ", " << std::setprecision(1) << *loudness << " LUFS";
    return text.str();
}

} // namespace idiophone
