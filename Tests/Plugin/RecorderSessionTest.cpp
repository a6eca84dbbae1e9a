#include "Plugin/RecorderSession.h"

#include "Plugin/WatchedHost.h"
#include "Support/HomeFolder.h"
#include "Support/SoundFile.h"
#include "Support/TestFolder.h"
#include "Support/WaitUntil.h"

#include <catch2/catch_test_macros.hpp>
#include <fstream>

using namespace idiophone;
using namespace idiophone::test;

namespace {

/// Plays a second of music, after silence.
HostSound playSecond(Processor& processor) {
    juce::MidiBuffer midi;
    midi.addEvents(testMusic(40000), 0, 40000, 8000);
    return render(processor, 48000, 480, midi);
}

struct Played {
    explicit Played(bool isKept = true) {
        if (isKept)
            recorder.keepLastSound();
        restore(processor, testState());
        processor.prepareToPlay(48000, 480);
    }
    const LastSound& lastSound() { return processor.engineReport().lastSound; }

    Processor processor;
    RecorderView& recorder = processor.view().recorder;
};

/// Returns the sound from its first to its last heard sample.
HostSound heardOf(const HostSound& sound) {
    const auto heard = withoutSilence({.left = sound.left, .right = sound.right});
    return {.left = heard.left, .right = heard.right};
}

} // namespace

TEST_CASE("The last sound takes memory only after a window has asked for it") {
    Played played(false);
    playSecond(played.processor);
    CHECK(played.lastSound().sound() == nullptr);
    CHECK_FALSE(played.recorder.hasLastSound());
    played.recorder.keepLastSound();
    REQUIRE(played.lastSound().sound() != nullptr);
    CHECK_FALSE(played.recorder.hasLastSound());
    playSecond(played.processor);
    CHECK(played.recorder.hasLastSound());
}

TEST_CASE("The last sound is written as it was heard, from its first to its last sample") {
    Played played;
    const auto output = playSecond(played.processor);
    const auto file = testFolder() / "last.wav";
    REQUIRE(played.recorder.writeLastSound(file));
    const auto read = readSoundFile(file);
    CHECK(read.sampleRateHz == 48000);
    REQUIRE(read.sound.left.size() > 30000);
    CHECK(read.sound.left.size() < 40001); // starts at the first note
    CHECK(read.sound == heardOf(output));
    std::filesystem::remove(file);
}

TEST_CASE("A file holds at most the last 30 seconds") {
    Played played;
    const auto before = playSecond(played.processor);
    auto output = render(played.processor, 29 * 48000, 480, testMusic(29 * 48000, 20000));
    output.append(playSecond(played.processor));
    const auto file = testFolder() / "30.wav";
    REQUIRE(played.recorder.writeLastSound(file));
    CHECK(readSoundFile(file).sound == heardOf(output));
    std::filesystem::remove(file);
}

TEST_CASE("An offline render does not replace what was played") {
    Played played;
    const auto output = playSecond(played.processor);
    played.processor.setNonRealtime(true);
    playSecond(played.processor);
    const auto file = testFolder() / "online.wav";
    REQUIRE(played.recorder.writeLastSound(file));
    CHECK(readSoundFile(file).sound == heardOf(output));
    std::filesystem::remove(file);
}

TEST_CASE("The last sound goes on when the host prepares again, and starts anew at another rate") {
    Played played;
    playSecond(played.processor);
    const auto former = played.lastSound().sound();
    played.processor.prepareToPlay(48000, 64);
    CHECK(played.lastSound().sound() == former);
    CHECK_FALSE(former->isRetired());
    CHECK(played.recorder.hasLastSound());
    played.processor.prepareToPlay(96000, 64);
    CHECK(former->isRetired());
    CHECK_FALSE(played.recorder.hasLastSound());
    playSecond(played.processor);
    const auto file = testFolder() / "96.wav";
    REQUIRE(played.recorder.writeLastSound(file));
    CHECK(readSoundFile(file).sampleRateHz == 96000);
    std::filesystem::remove(file);
}

TEST_CASE("A sound that cannot be written is reported in one sentence") {
    Played played;
    playSecond(played.processor);
    CHECK_FALSE(played.recorder.writeLastSound(testFolder() / "missing" / "last.wav"));
    const auto status = played.processor.view().status.takeStatus();
    CHECK(status.isError);
    CHECK(status.sentence ==
          "The sound was not written: " + (testFolder() / "missing" / "last.wav").string() +
              ": the file cannot be written.");
}

TEST_CASE("A new sound file is named after the preset and the time") {
    Played played;
    auto state = testState();
    state.preset.name = "Bell: 2/3";
    restore(played.processor, state);
    const auto name = fromUtf8(played.recorder.newName());
    CHECK(name.startsWith("Bell 23 20"));
    CHECK(name == juce::File::createLegalFileName(name));
    CHECK(name.length() == juce::String("Bell 23 2026-11-26 15.31.02").length());
}

TEST_CASE("Keeping the last sound neither allocates, locks nor calls the system") {
    if (!realTimeTrapWorks())
        SKIP("the trap needs Linux with glibc and no sanitizer");
    WatchedHost host(480);
    host.processor.view().recorder.keepLastSound();
    const auto music = testMusic(480, 200);
    for (int block = 0; block < 40; ++block)
        host.block(music, 480);
    CHECK(host.processor.view().recorder.hasLastSound());
}

#ifndef _WIN32
TEST_CASE("A recording lies in the music folder, as it was heard") {
    const HomeFolder home;
    Played played;
    playSecond(played.processor);
    played.recorder.startRecording();
    CHECK(played.recorder.recording().isRunning);
    const auto output = playSecond(played.processor);
    played.recorder.stopRecording();
    const auto made = played.recorder.recording();
    CHECK_FALSE(made.isRunning);
    CHECK(made.seconds == 1);
    CHECK(made.file.parent_path() == home.music());
    CHECK(made.file.filename().string().starts_with("Test keyboard 20"));
    CHECK(made.file.extension() == ".wav");
    CHECK(readSoundFile(made.file).sound == output); // silence stays
    CHECK_FALSE(played.processor.view().status.takeStatus().isError);
}

TEST_CASE("A plugin that closes while it records completes the file") {
    const HomeFolder home;
    HostSound output;
    {
        Played played(false);
        played.recorder.startRecording(); // no window has asked for the last sound before
        output = playSecond(played.processor);
    }
    auto files = std::filesystem::directory_iterator(home.music());
    REQUIRE(files != std::filesystem::directory_iterator());
    CHECK(readSoundFile(files->path()).sound == output);
}

TEST_CASE("A recording without a folder, or before the host has a sample rate, does not start") {
    const HomeFolder home;
    Processor unprepared;
    unprepared.view().recorder.startRecording();
    CHECK(unprepared.view().status.takeStatus().sentence ==
          "The recording cannot start: the host has not started the sound yet.");
    std::ofstream(home.music().parent_path()) << "a file where the music folder should be";
    Played played;
    played.recorder.startRecording();
    CHECK_FALSE(played.recorder.recording().isRunning);
    CHECK(played.processor.view().status.takeStatus().sentence ==
          "The recording cannot start: there can be no folder " + home.music().string() + ".");
}

TEST_CASE("A recording that ends by itself is reported") {
    const HomeFolder home;
    Played played;
    played.recorder.startRecording();
    played.processor.prepareToPlay(96000, 480);
    waitUntil([&] { return !played.recorder.recording().isRunning; });
    played.processor.poll();
    CHECK(played.processor.view().status.takeStatus().sentence ==
          "The recording has ended, because the sample rate has changed.");
}
#endif
