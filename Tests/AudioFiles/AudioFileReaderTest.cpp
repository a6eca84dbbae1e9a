#include "AudioFiles/AudioFileReader.h"

#include "AudioFiles/WrittenSound.h"
#include "Object/TextFile.h"
#include "Support/TestFolder.h"

#include <cstdint>

using namespace idiophone;
using namespace idiophone::test;

namespace {

std::string number(std::uint32_t value, int bytes, bool isBigEndian = false) {
    std::string text;
    for (int i = 0; i < bytes; ++i)
        text += static_cast<char>(value >> 8 * (isBigEndian ? bytes - 1 - i : i));
    return text;
}

std::string chunk(const std::string& name, const std::string& content, std::uint32_t length) {
    return name + number(length, 4) + content;
}

std::string wav(const std::string& chunks, std::uint32_t length) {
    const auto format = number(1, 2) + number(1, 2) + number(8000, 4) + number(16000, 4) +
                        number(2, 2) + number(16, 2);
    return "RIFF" + number(length, 4) + "WAVE" + chunk("fmt ", format, 16) + chunks;
}

const std::string fourSamples =
    number(0x0000, 2) + number(0x4000, 2) + number(0x8000, 2) + number(0xc000, 2);
const std::vector<float> fourValues{0, 0.5f, -1, -0.5f};

/// An AIFF file of the four samples at 48 kHz.
std::string aiff() {
    const auto big = [](std::uint32_t value, int bytes) { return number(value, bytes, true); };
    std::string samples;
    for (std::size_t i = 0; i < fourSamples.size(); i += 2)
        samples += {fourSamples[i + 1], fourSamples[i]};
    const auto rate = big(0x400e, 2) + big(0xbb800000, 4) + big(0, 4); // an 80-bit float
    const auto chunks = "COMM" + big(18, 4) + big(1, 2) + big(4, 4) + big(16, 2) + rate + "SSND" +
                        big(16, 4) + big(0, 4) + big(0, 4) + samples;
    return "FORM" + big(static_cast<std::uint32_t>(4 + chunks.size()), 4) + "AIFF" + chunks;
}

Result<MonoRecording> readBytesAs(const std::string& name, const std::string& bytes) {
    REQUIRE(writeTextFile(testFolder() / name, bytes));
    return readRecording(testFolder() / name);
}

void checkRefused(const std::string& name, const std::string& bytes, const std::string& sentence) {
    const auto read = readBytesAs(name, bytes);
    REQUIRE(!read);
    CHECK(read.error().message.ends_with(name + ": " + sentence));
}

} // namespace

TEST_CASE("A WAV file of unknown length is read to its end") {
    const auto list = chunk("LIST", "INFOISFT" + number(4, 4) + "abcd", 16);
    for (const std::uint32_t length : {0u, 0xffffffffu, 0x7ffff000u})
        for (const std::uint32_t riff : {0u, 0xffffffffu, 0x7ffff024u}) {
            const auto read =
                readBytesAs("pipe.wav", wav(list + chunk("data", fourSamples, length), riff));
            REQUIRE(read);
            CHECK(read->samples == fourValues);
            CHECK(read->sampleRateHz == 8000);
        }
}

TEST_CASE("A WAV file without samples stays empty if its length is known") {
    const auto chunks = chunk("data", "", 0) + chunk("LIST", "INFO", 4);
    const auto read = readBytesAs("empty.wav", wav(chunks, 28 + 20));
    REQUIRE(read);
    CHECK(read->samples.empty());
    CHECK(read->sampleRateHz == 8000);
}

TEST_CASE("An RF64 file is read by its own length, or to its end") {
    for (const std::uint32_t length : {8u, 0u, 0xffffffffu}) {
        auto bytes = wav(chunk("data", fourSamples, 0xffffffff), 0xffffffff);
        bytes.replace(0, 4, "RF64");
        const auto high = length == 0xffffffff ? length : 0;
        bytes.insert(12, chunk("ds64",
                               number(80, 4) + number(0, 4) + number(length, 4) + number(high, 4) +
                                   std::string(12, '\0'),
                               28));
        const auto read = readBytesAs("long.wav", bytes);
        REQUIRE(read);
        CHECK(read->samples == fourValues);
    }
}

TEST_CASE("WAV, FLAC and AIFF files of a sound are read alike, channels mixed") {
    const auto read = readBytesAs("four.aiff", aiff());
    REQUIRE(read);
    CHECK(read->samples == fourValues);
    CHECK(read->sampleRateHz == 48000);

    const auto left = tone(10000);
    const std::vector<float> right(10000, 0);
    for (const auto* name : {"tone.wav", "tone.flac"}) {
        const auto writer = AudioFileWriter::create(testFolder() / name, 48000, 2, 24);
        REQUIRE(writer);
        const float* channels[] = {left.data(), right.data()};
        REQUIRE((*writer)->write(channels, 10000));
        REQUIRE((*writer)->finish());
    }
    const auto wave = readRecording(testFolder() / "tone.wav");
    const auto flac = readRecording(testFolder() / "tone.flac");
    REQUIRE(wave);
    REQUIRE(flac);
    CHECK((wave->samples == flac->samples));
    REQUIRE(wave->samples.size() == left.size());
    CHECK(std::abs(wave->samples[40] - left[40] / 2) < 1e-6f);
    const auto both = readChannels(testFolder() / "tone.flac");
    REQUIRE(both);
    CHECK(both->channelCount == 2);
    REQUIRE(both->samples.size() == 2 * left.size());
    CHECK(std::abs(both->samples[80] - left[40]) < 1e-6f);
    CHECK(both->samples[81] == 0);
}

TEST_CASE("A FLAC file of unknown length is read to its end") {
    const auto file = testFolder() / "tone.flac";
    writeSound(file, tone(10000), 16);
    auto bytes = bytesOf(file);
    bytes[21] = static_cast<char>(bytes[21] & 0xf0); // the 36 bits that count the samples
    bytes.replace(22, 4, 4, '\0');
    const auto read = readBytesAs("pipe.flac", bytes);
    REQUIRE(read);
    CHECK((read->samples == readRecording(file)->samples));
}

TEST_CASE("A recording that cannot be read gets a sentence about its fault") {
    const std::string shorter = "it is shorter than its header says";
    const std::string other = "it is not a WAV, FLAC or AIFF file";
    checkRefused("cut.wav", wav(chunk("data", fourSamples, 1000), 1036), shorter);
    checkRefused("cut.aiff", aiff().substr(0, aiff().size() - 4), shorter);
    checkRefused("empty.wav", "", other);
    checkRefused("tone.mp3", "ID3\3 some tags", other);
    checkRefused("headless.wav", wav(chunk("LIST", "INFO", 4), 40),
                 "it is damaged, or of a kind of WAV that cannot be read (No 'data' chunk marker)");
    auto slow = wav(chunk("data", fourSamples, 8), 44);
    slow.replace(24, 4, number(100, 4));
    checkRefused("slow.wav", slow, "its sample rate is not 1 kHz to 1 MHz");
    checkRefused("long.wav", wav(chunk("data", std::string(2 * 600 * 8000 + 2, '\0'), 9600002), 0),
                 "it is longer than ten minutes");

    writeSound(testFolder() / "tone.flac", tone(10000), 16);
    auto cut = bytesOf(testFolder() / "tone.flac");
    cut.resize(cut.size() / 2);
    checkRefused("cut.flac", cut, shorter);
}
