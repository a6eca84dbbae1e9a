// Passes small messages from one thread to another without a lock.
#pragma once

#include <array>
#include <juce_core/juce_core.h>
#include <type_traits>

namespace idiophone {

template <class Message, int capacityOfQueue>
class OneWayQueue {
    static_assert(std::is_trivially_copyable_v<Message>);

public:
    static constexpr int capacity = capacityOfQueue;

    /// [the sending thread] Returns false and drops the message if the queue is full.
    bool push(const Message& message) noexcept {
        const auto scope = fifo.write(1);
        if (scope.blockSize1 + scope.blockSize2 == 0)
            return false;
        messages[static_cast<std::size_t>(scope.blockSize1 > 0 ? scope.startIndex1
                                                               : scope.startIndex2)] = message;
        return true;
    }

    /// [the reading thread] Hands each pending message to `take`, oldest first; at most `capacity`
    /// of them.
    template <class Take>
    void read(Take&& take) noexcept {
        const auto scope = fifo.read(fifo.getNumReady());
        scope.forEach([&](int index) { take(messages[static_cast<std::size_t>(index)]); });
    }

private:
    juce::AbstractFifo fifo{capacity};
    std::array<Message, capacity> messages{};
};

} // namespace idiophone
