#include "AudioFiles/AudioFileWriter.h"
#include "AudioFiles/AudioFileReader.h"
#include "AudioFiles/WrittenSound.h"
#include "Support/TestFolder.h"

#include <algorithm>

using namespace idiophone;
using namespace idiophone::test;

TEST_CASE("Floats are written unchanged, also above full scale") {
    auto sound = tone(5000);
    sound[7] = -3.25f;
    writeSound(testFolder() / "tone.wav", sound, 32);
    const auto read = readRecording(testFolder() / "tone.wav");
    REQUIRE(read);
    CHECK((read->samples == sound));
    CHECK(read->sampleRateHz == 48000);
}

TEST_CASE("Whole numbers are rounded to the nearest step and clip at full scale") {
    auto sound = tone(5000);
    sound[7] = -3.25f;
    sound[8] = 3.25f;
    for (const auto& [name, bits] : {std::pair{"16.wav", 16}, {"24.wav", 24}, {"24.flac", 24}}) {
        writeSound(testFolder() / name, sound, bits);
        const auto read = readRecording(testFolder() / name);
        REQUIRE(read);
        REQUIRE(read->samples.size() == sound.size());
        const double step = std::ldexp(1.0, 1 - bits);
        double worst = 0;
        for (std::size_t i = 0; i < sound.size(); ++i)
            worst = std::max(worst, std::abs(std::clamp<double>(sound[i], -1, 1 - step) -
                                             static_cast<double>(read->samples[i])));
        CHECK(worst <= 0.501 * step);
    }
}

TEST_CASE("A file of floats is a plain WAV file that does not tell the time") {
    writeSound(testFolder() / "tone.wav", tone(500), 32);
    const auto bytes = bytesOf(testFolder() / "tone.wav");
    CHECK(bytes.starts_with("RIFF"));
    CHECK(bytes.find("PEAK") == std::string::npos); // a chunk with the time of writing
}

TEST_CASE("An unfinished file leaves nothing behind") {
    const auto folder = testFolder() / "unfinished";
    std::filesystem::create_directory(folder);
    {
        const auto writer = AudioFileWriter::create(folder / "tone.flac", 48000, 1, 24);
        REQUIRE(writer);
        const auto sound = tone(50000);
        const float* channels[] = {sound.data()};
        REQUIRE((*writer)->write(channels, 50000));
    }
    CHECK(std::filesystem::is_empty(folder));
}

TEST_CASE("A FLAC file of floats is refused") {
    const auto writer = AudioFileWriter::create(testFolder() / "tone.flac", 48000, 1, 32);
    REQUIRE(!writer);
    CHECK(writer.error().message.ends_with("tone.flac: a FLAC file has 16 or 24 bits, not 32"));
}
