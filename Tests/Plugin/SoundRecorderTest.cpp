#include "Plugin/SoundRecorder.h"

#include "Support/FullDisk.h"
#include "Support/SoundFile.h"
#include "Support/TestFolder.h"
#include "Support/WaitUntil.h"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <limits>

using namespace idiophone;
using namespace idiophone::test;

namespace {

/// A rolling sound of two seconds at 1 kHz, whose frames count up.
struct Source {
    std::shared_ptr<RollingSound> sound = std::make_shared<RollingSound>(1000, 2000);
    float next = 0;

    HostSound write(std::size_t count) {
        HostSound written;
        for (std::size_t i = 0; i < count; ++i) {
            written.left.push_back(next / 1024);
            written.right.push_back(-next / 1024);
            ++next;
        }
        const std::array<const float*, 2> channels{written.left.data(), written.right.data()};
        sound->write(channels, count);
        return written;
    }
};

void waitUntilEnded(const SoundRecorder& recorder) {
    waitUntil([&] { return !recorder.state().isRunning; });
}

} // namespace

TEST_CASE("A recording holds every frame between start and stop, longer than the rolling sound") {
    Source source;
    source.write(500);
    const auto file = testFolder() / "recording.wav";
    SoundRecorder recorder;
    REQUIRE(recorder.start(source.sound, file));
    CHECK(recorder.state().isRunning);
    HostSound played;
    for (int second = 1; second <= 5; ++second) {
        played.append(source.write(1000));
        waitUntil([&] { return recorder.state().seconds >= second; });
    }
    CHECK_FALSE(std::filesystem::exists(file)); // not before it is complete
    played.append(source.write(250));
    recorder.stop();
    source.write(100);
    const auto state = recorder.state();
    CHECK_FALSE(state.isRunning);
    CHECK(state.seconds == 5.25);
    CHECK(state.file == file);
    CHECK(recorder.takeError().empty());
    CHECK(readSoundFile(file).sound == played);
    CHECK(readSoundFile(file).sampleRateHz == 1000);
}

TEST_CASE("A recording is completed when its recorder is destroyed or started again") {
    Source source;
    const auto first = testFolder() / "first.wav", second = testFolder() / "second.wav";
    HostSound played, after;
    {
        SoundRecorder recorder;
        REQUIRE(recorder.start(source.sound, first));
        played = source.write(300);
        REQUIRE(recorder.start(source.sound, second));
        CHECK(recorder.state().file == first);
        after = source.write(200);
    }
    CHECK(readSoundFile(first).sound == played);
    CHECK(readSoundFile(second).sound == after);
}

TEST_CASE("A recording ends with its sound, and says why") {
    Source source;
    const auto file = testFolder() / "retired.wav";
    SoundRecorder recorder;
    REQUIRE(recorder.start(source.sound, file));
    const auto played = source.write(300);
    source.sound->retire();
    waitUntilEnded(recorder);
    CHECK(readSoundFile(file).sound == played);
    CHECK(recorder.takeError() == "The recording has ended, because the sample rate has changed.");
    CHECK(recorder.takeError().empty());
}

TEST_CASE("A recording ends before the disk is full") {
    Source source;
    const auto file = testFolder() / "almost.wav";
    SoundRecorder recorder(std::numeric_limits<std::uintmax_t>::max());
    REQUIRE(recorder.start(source.sound, file));
    waitUntilEnded(recorder);
    CHECK(std::filesystem::exists(file));
    CHECK(recorder.takeError() == "The recording has ended, because the disk is almost full.");
}

#ifndef _WIN32
TEST_CASE("A recording that cannot be written is reported, and leaves no file") {
    Source source;
    const auto folder = testFolder() / "full";
    std::filesystem::create_directories(folder);
    const auto file = folder / "lost.wav";
    SoundRecorder recorder;
    REQUIRE(recorder.start(source.sound, file));
    {
        const FullDisk disk(1000);
        source.write(2000);
        recorder.stop();
    }
    CHECK(recorder.takeError() ==
          "The recording is lost: " + file.string() + ": the file cannot be written.");
    CHECK(recorder.state().file.empty());
    CHECK(std::filesystem::is_empty(folder));
}
#endif

TEST_CASE("A recording does not start in a folder that does not exist") {
    Source source;
    const auto file = testFolder() / "nowhere" / "recording.wav";
    SoundRecorder recorder;
    const auto started = recorder.start(source.sound, file);
    REQUIRE_FALSE(started);
    CHECK(started.error().message == file.string() + ": the file cannot be written");
    CHECK_FALSE(recorder.state().isRunning);
}
