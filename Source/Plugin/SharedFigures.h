// Shares a few numbers that one thread writes and any thread reads. Neither side waits.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>

namespace idiophone {

/// `Figures` holds only doubles. Each double is read whole, but a reader during a write may see a
/// mix of old and new ones.
template <class Figures>
class SharedFigures {
public:
    SharedFigures() { store({}); }

    /// Call from one thread at a time.
    void store(const Figures& figures) noexcept {
        const auto values = std::bit_cast<Values>(figures);
        for (std::size_t i = 0; i < count; ++i)
            shared[i] = values[i];
    }

    Figures load() const noexcept {
        Values values;
        for (std::size_t i = 0; i < count; ++i)
            values[i] = shared[i];
        return std::bit_cast<Figures>(values);
    }

private:
    static constexpr std::size_t count = sizeof(Figures) / sizeof(double);
    using Values = std::array<double, count>;
    std::array<std::atomic<double>, count> shared;
};

} // namespace idiophone
