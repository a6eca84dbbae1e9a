// Fuzzes recordings, as `idiophone fit` and `idiophone surface` read them.
#include "AudioFiles/AudioFileReader.h"
#include "Fuzz/FuzzTarget.h"

void idiophone::fuzz::examine(std::string_view bytes) {
    const auto recording = readRecording(scratchFile(bytes, "fuzz.wav"));
    if (!recording)
        return claimSentence(recording.error());
    claim(recording->sampleRateHz >= 1000 && recording->sampleRateHz <= 1e6,
          "the sample rate is one of sound");
    claim(static_cast<double>(recording->samples.size()) <= 600 * recording->sampleRateHz,
          "a recording lasts ten minutes at most");
}
