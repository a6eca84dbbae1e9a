#include "Plugin/OneWayQueue.h"

#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <thread>
#include <vector>

using namespace idiophone;

namespace {

template <class Queue>
std::vector<int> readAll(Queue& queue) {
    std::vector<int> read;
    queue.read([&](int message) { read.push_back(message); });
    return read;
}

} // namespace

TEST_CASE("Messages are read once and in order, at any position of the ring") {
    OneWayQueue<int, 8> queue;
    CHECK(readAll(queue).empty());
    for (int turn = 0; turn < 20; ++turn) {
        std::vector<int> sent;
        for (int k = 0; k < 1 + turn % 7; ++k) {
            sent.push_back(100 * turn + k);
            CHECK(queue.push(sent.back()));
        }
        CHECK(readAll(queue) == sent);
        CHECK(readAll(queue).empty());
    }
}

TEST_CASE("A full queue refuses new messages, keeps the old ones, and has space after a read") {
    using Queue = OneWayQueue<int, 8>;
    Queue queue;
    for (int turn = 0; turn < 10; ++turn) {
        std::vector<int> taken;
        for (int message = 0; message < 2 * Queue::capacity; ++message)
            if (queue.push(message))
                taken.push_back(message);
        CHECK(taken.size() >= Queue::capacity - 1);
        CHECK(taken.size() <= Queue::capacity);
        CHECK(taken.back() ==
              static_cast<int>(taken.size()) - 1); // none is accepted after a refusal
        CHECK(readAll(queue) == taken);
    }
}

TEST_CASE("Between threads messages arrive complete, in order and without loss") {
    struct Message {
        int number = 0;
        std::array<int, 31> copies{};
    };
    constexpr int last = 20'000;
    OneWayQueue<Message, 16> queue;
    std::atomic<bool> isAllSent{false};
    std::thread sender([&] {
        for (int number = 1; number <= last; ++number) {
            Message message{.number = number, .copies = {}};
            message.copies.fill(number);
            while (!queue.push(message))
                std::this_thread::yield();
        }
        isAllSent = true;
    });
    int seen = 0;
    bool isInOrder = true, isWhole = true;
    for (bool isOver = false; !isOver;) {
        isOver = isAllSent; // this round reads the last messages
        queue.read([&](const Message& message) {
            isInOrder = isInOrder && message.number == seen + 1;
            seen = message.number;
            for (const int copy : message.copies)
                isWhole = isWhole && copy == message.number;
        });
        std::this_thread::yield();
    }
    sender.join();
    CHECK(seen == last);
    CHECK(isInOrder);
    CHECK(isWhole);
}
