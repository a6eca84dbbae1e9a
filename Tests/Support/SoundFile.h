// Reads a WAV file that a test made.
#pragma once

#include "Editor/Utf8.h"
#include "Support/TestSound.h"

#include <filesystem>
#include <juce_audio_formats/juce_audio_formats.h>
#include <memory>

namespace idiophone::test {

struct SoundFile {
    HostSound sound = {}; ///< empty if it is no stereo WAV file of floats
    double sampleRateHz = 0;
};

inline SoundFile readSoundFile(const std::filesystem::path& file) {
    const std::unique_ptr<juce::AudioFormatReader> reader(
        juce::WavAudioFormat().createReaderFor(fileOf(file).createInputStream().release(), true));
    if (reader == nullptr || reader->numChannels != 2 || !reader->usesFloatingPointData)
        return {};
    juce::AudioBuffer<float> samples(2, static_cast<int>(reader->lengthInSamples));
    reader->read(&samples, 0, samples.getNumSamples(), 0, true, true);
    SoundFile result{.sampleRateHz = reader->sampleRate};
    result.sound.append(samples);
    return result;
}

} // namespace idiophone::test
