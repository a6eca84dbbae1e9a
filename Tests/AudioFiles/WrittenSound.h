// Writes a sound by AudioFileWriter, and reads the bytes of files.
#pragma once

#include "AudioFiles/AudioFileWriter.h"
#include "Object/FileBytes.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <string>
#include <vector>

namespace idiophone::test {

/// Returns a decaying tone of peak 0.8.
inline std::vector<float> tone(std::size_t count) {
    std::vector<float> samples(count);
    for (std::size_t i = 0; i < count; ++i)
        samples[i] = 0.8f * std::exp(-0.001f * static_cast<float>(i)) *
                     std::sin(0.05f * static_cast<float>(i));
    return samples;
}

/// Writes a mono sound at 48 kHz.
inline void writeSound(const std::filesystem::path& file, std::vector<float> samples, int bits) {
    const auto writer = AudioFileWriter::create(file, 48000, 1, bits);
    REQUIRE(writer);
    const float* channels[] = {samples.data()};
    REQUIRE((*writer)->write(channels, static_cast<int>(samples.size())));
    REQUIRE((*writer)->finish());
}

inline std::string bytesOf(const std::filesystem::path& file) {
    return readBytes(file, 1 << 24).value();
}

} // namespace idiophone::test
