// Hands the newest of a series of large values from one thread to another: a triple buffer.
#pragma once

#include <array>
#include <atomic>

namespace idiophone {

/// Neither side waits, allocates or sees a value half written. A value not read before the next one
/// is lost.
template <class Value>
class LatestValue {
public:
    /// Initialises all three buffers to `value`.
    explicit LatestValue(const Value& value) : values{value, value, value} {}
    LatestValue(const LatestValue&) = delete;
    LatestValue& operator=(const LatestValue&) = delete;

    /// [the writing thread] Returns the buffer that `publish` hands over. At first the buffer holds
    /// an old value.
    Value& next() noexcept { return values[writing]; }
    void publish() noexcept { writing = spare.exchange(writing | isNew) & index; }

    /// [the reading thread] Returns the newest published value, valid until the next call, or
    /// nullptr if it was read already.
    const Value* take() noexcept {
        if ((spare.load() & isNew) == 0)
            return nullptr;
        reading = spare.exchange(reading) & index;
        return &values[reading];
    }

private:
    static constexpr unsigned index = 3, isNew = 4;

    std::array<Value, 3> values;
    unsigned writing = 0;           ///< the writing thread's
    unsigned reading = 1;           ///< the reading thread's
    std::atomic<unsigned> spare{2}; ///< held by neither thread; with `isNew` if unread
    static_assert(std::atomic<unsigned>::is_always_lock_free);
};

} // namespace idiophone
