#include "Plugin/RollingSound.h"

#include <algorithm>
#include <cmath>

namespace idiophone {

RollingSound::RollingSound(double sampleRateHz, std::size_t frameCount)
    : rateHz(sampleRateHz), capacity(frameCount),
      frames(std::make_unique<std::atomic<Frame>[]>(frameCount)) {}

// Frames are released and acquired, so that a reader who has copied a new frame also sees the count
// that announced it.

void RollingSound::write(std::span<const float* const> channels, std::size_t count) noexcept {
    if (channels.empty())
        return;
    const float* const left = channels.front();
    const float* const right = channels[channels.size() > 1 ? 1 : 0];
    const auto start = written.load(std::memory_order_relaxed);
    begun.store(start + count, std::memory_order_relaxed);
    auto place = static_cast<std::size_t>(start % capacity);
    for (std::size_t i = 0; i < count; ++i) {
        frames[place].store({left[i], right[i]}, std::memory_order_release);
        if (++place == capacity)
            place = 0;
    }
    written.store(start + count, std::memory_order_release);
}

RollingSound::Piece RollingSound::read(std::uint64_t from) const {
    const auto stop = end();
    Piece piece{.first = std::max(from, stop - std::min<std::uint64_t>(stop, capacity))};
    piece.left.reserve(static_cast<std::size_t>(stop - piece.first));
    piece.right.reserve(piece.left.capacity());
    for (auto at = piece.first; at < stop; ++at) {
        const auto frame =
            frames[static_cast<std::size_t>(at % capacity)].load(std::memory_order_acquire);
        piece.left.push_back(frame[0]);
        piece.right.push_back(frame[1]);
    }
    const auto newest = begun.load(std::memory_order_relaxed);
    const auto oldest = newest - std::min<std::uint64_t>(newest, capacity);
    if (oldest > piece.first) {
        const auto lost = static_cast<std::ptrdiff_t>(std::min(oldest, piece.end()) - piece.first);
        piece.left.erase(piece.left.begin(), piece.left.begin() + lost);
        piece.right.erase(piece.right.begin(), piece.right.begin() + lost);
        piece.first += static_cast<std::uint64_t>(lost);
    }
    return piece;
}

RollingSound::Piece withoutSilence(const RollingSound::Piece& piece) {
    constexpr float threshold = 1e-5f;
    const auto sounds = [&](std::size_t i) {
        return std::max(std::abs(piece.left[i]), std::abs(piece.right[i])) > threshold;
    };
    std::size_t start = 0, stop = piece.left.size();
    while (start < stop && !sounds(start))
        ++start;
    while (start < stop && !sounds(stop - 1))
        --stop;
    const auto part = [&](const std::vector<float>& samples) {
        return std::vector(samples.begin() + static_cast<std::ptrdiff_t>(start),
                           samples.begin() + static_cast<std::ptrdiff_t>(stop));
    };
    return {.first = piece.first + start, .left = part(piece.left), .right = part(piece.right)};
}

} // namespace idiophone
