// Some numbers that one thread writes and any may read, without waiting for each other.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>

namespace idiophone {

/// `Figures` has nothing but doubles. Each crosses whole; who reads while others are written may
/// have some of both.
template <class Figures>
class SharedFigures {
public:
    SharedFigures() { store({}); }

    /// By one thread at a time.
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
