// Writes recordings of strikes into the test's own folder.
#pragma once

#include "AudioFiles/AudioFileWriter.h"
#include "Object/ModalObject.h"
#include "Support/TestFolder.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace idiophone::test {

struct Tone {
    double hz, decayPerSecond, amplitude;
};

/// Writes a second of the tones after a fifth of a second of silence, as the file's extension says.
inline std::filesystem::path recordedStrike(const std::string& name,
                                            const std::vector<Tone>& tones) {
    constexpr int rate = 48000;
    std::vector<float> samples(rate / 5);
    for (int i = 0; i < rate; ++i) {
        double sample = 0;
        for (const auto& [hz, decay, amplitude] : tones)
            sample += amplitude * std::exp(-decay * i / rate) *
                      std::sin(2 * std::numbers::pi * hz * i / rate);
        samples.push_back(static_cast<float>(sample));
    }
    const auto file = testFolder() / name;
    const auto writer = AudioFileWriter::create(file, rate, 1, 24);
    const float* const channel = samples.data();
    if (!writer || !(*writer)->write(&channel, static_cast<int>(samples.size())) ||
        !(*writer)->finish())
        throw std::runtime_error("cannot write " + file.string());
    return file;
}

/// Returns the modes of an object below 16 kHz as they sound where it is struck, 0.9 in all.
inline std::vector<Tone> tonesOf(const ModalObject& object, std::size_t shapeRow) {
    std::vector<Tone> tones;
    double sum = 0;
    const auto shapes = object.shapesAt(shapeRow);
    for (std::size_t mode = 0; mode < object.modeCount(); ++mode)
        if (object.dampedFrequencyHz(mode) < 16000) {
            double strength = 0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                strength += std::pow(double(shapes[3 * mode + axis]), 2);
            sum += strength;
            tones.push_back(
                {object.dampedFrequencyHz(mode), object.decayPerSecond(mode), strength});
        }
    for (auto& tone : tones)
        tone.amplitude *= 0.9 / sum;
    return tones;
}

} // namespace idiophone::test
