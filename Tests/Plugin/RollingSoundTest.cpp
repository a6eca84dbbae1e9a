#include "Plugin/RollingSound.h"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <thread>

using namespace idiophone;

namespace {

/// Writes the frames {n, -n} of the counts n from `from` on.
void writeCounts(RollingSound& sound, std::uint64_t from, std::size_t count) {
    std::vector<float> left, right;
    for (std::size_t i = 0; i < count; ++i) {
        left.push_back(static_cast<float>(from + i));
        right.push_back(-left.back());
    }
    const std::array<const float*, 2> channels{left.data(), right.data()};
    sound.write(channels, count);
}

bool isCounts(const RollingSound::Piece& piece) {
    for (std::size_t i = 0; i < piece.left.size(); ++i)
        if (const auto count = static_cast<float>(piece.first + i);
            piece.left[i] != count || piece.right[i] != -count)
            return false;
    return piece.left.size() == piece.right.size();
}

} // namespace

TEST_CASE("A rolling sound keeps its newest frames") {
    RollingSound sound(48000, 100);
    CHECK(sound.read(0).left.empty());
    for (std::uint64_t start = 0; start < 250; start += 50)
        writeCounts(sound, start, 50);
    CHECK(sound.end() == 250);
    const auto all = sound.read(0);
    CHECK(all.first == 150);
    CHECK(all.end() == 250);
    CHECK(isCounts(all));
    const auto newest = sound.read(240);
    CHECK(newest.first == 240);
    CHECK(newest.left.size() == 10);
    CHECK(isCounts(newest));
    CHECK(sound.read(250).left.empty());
}

TEST_CASE("A rolling sound keeps a mono output in both channels, and nothing without channels") {
    RollingSound sound(48000, 100);
    const std::array<float, 3> samples{0.1f, 0.2f, 0.3f};
    const std::array<const float*, 1> mono{samples.data()};
    sound.write(mono, samples.size());
    sound.write({}, samples.size());
    const auto kept = sound.read(0);
    CHECK(kept.left == std::vector(samples.begin(), samples.end()));
    CHECK(kept.right == kept.left);
}

TEST_CASE("Frames that are overwritten while they are read are dropped") {
    RollingSound sound(48000, 1000);
    constexpr std::uint64_t frames = 4'000'000; // counts up to 2^24 are exact floats
    std::thread writer([&] {
        for (std::uint64_t start = 0; start < frames; start += 64)
            writeCounts(sound, start, 64);
    });
    bool areRight = true, arePieces = true;
    std::uint64_t next = 0;
    while (next < frames) {
        const auto piece = sound.read(next);
        areRight = areRight && isCounts(piece);
        arePieces = arePieces && piece.first >= next && piece.left.size() <= 1000;
        next = piece.end();
    }
    writer.join();
    CHECK(areRight);
    CHECK(arePieces);
    CHECK(next == frames);
}

TEST_CASE("Silence at both ends is cut off, but not between sounds") {
    const RollingSound::Piece piece{
        .first = 7, .left = {0, 1e-6f, 0, 0, 0.5f, 0, 0}, .right = {0, 0, 0.1f, 0, 0, 0, -1e-6f}};
    const auto heard = withoutSilence(piece);
    CHECK(heard.first == 9);
    CHECK(heard.left == std::vector{0.0f, 0.0f, 0.5f});
    CHECK(heard.right == std::vector{0.1f, 0.0f, 0.0f});
    CHECK(withoutSilence({.left = {0, 1e-6f}, .right = {0, 0}}).left.empty());
    CHECK(withoutSilence({}).left.empty());
}
