// Keeps the newest frames of a stereo stream, which one thread writes and others read meanwhile.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace idiophone {

/// Frames are counted from the first one written. A reader copies first, and then drops what the
/// writer has overwritten meanwhile; so neither waits for the other.
class RollingSound {
public:
    /// Successive frames of a stream; both channels have the same length.
    struct Piece {
        std::uint64_t first = 0; ///< count of its first frame
        std::vector<float> left = {}, right = {};

        std::uint64_t end() const { return first + left.size(); }
    };

    /// Holds `frameCount` frames, at least 1. Allocates 8 bytes for each.
    RollingSound(double sampleRateHz, std::size_t frameCount);

    double sampleRateHz() const noexcept { return rateHz; }

    /// [audio thread] Appends up to `frameCount` frames. Takes one channel for both, ignores more
    /// than two, and writes nothing without any. Neither allocates, locks nor throws.
    void write(std::span<const float* const> channels, std::size_t count) noexcept;

    /// [any thread] The number of frames written so far.
    std::uint64_t end() const noexcept { return written.load(std::memory_order_acquire); }
    /// [any thread] Returns the frames from `from` on that are still kept.
    Piece read(std::uint64_t from) const;

    /// [any thread] Says that no frame follows.
    void retire() noexcept { retired = true; }
    bool isRetired() const noexcept { return retired; }

private:
    using Frame = std::array<float, 2>;
    static_assert(std::atomic<Frame>::is_always_lock_free);

    const double rateHz;
    const std::size_t capacity;
    const std::unique_ptr<std::atomic<Frame>[]> frames;
    std::atomic<std::uint64_t> begun{0};   ///< end of the frames being written
    std::atomic<std::uint64_t> written{0}; ///< end of the frames that can be read
    std::atomic<bool> retired{false};
};

/// Returns the part from the first to the last sample above the threshold of hearing (-100 dB of
/// full scale). Its channels are empty if there is none.
RollingSound::Piece withoutSilence(const RollingSound::Piece& piece);

} // namespace idiophone
