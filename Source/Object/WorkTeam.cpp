// SPDX-License-Identifier: Apache-2.0
#include "Object/WorkTeam.h"

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace idiophone {
namespace {

constexpr int pollsBeforeYield = 50'000; // about 0.05 ms
constexpr int yieldsBeforeSleep = 2000;  // about a millisecond
constexpr std::size_t batchesOfThread = 32;

} // namespace

struct WorkTeam::Threads {
    /// Threads that wait for conditions on atomic values. Not by std::atomic::wait, which loses
    /// wakes in gcc 12's library for Windows.
    class Sleepers {
    public:
        /// Waits for a short time without giving the core away, then lets others run between the
        /// polls, and then sleeps.
        template <class Condition>
        void waitUntil(const Condition& condition) {
            for (int poll = 0; poll < pollsBeforeYield + yieldsBeforeSleep; ++poll) {
                if (condition())
                    return;
                if (poll >= pollsBeforeYield)
                    std::this_thread::yield();
            }
            std::unique_lock lock(turn);
            ++count;
            woken.wait(lock, condition);
            --count;
        }

        /// Call it after each change of a value.
        void wake() {
            if (count == 0)
                return;
            { const std::scoped_lock lock(turn); } // none is between its look and its sleep
            woken.notify_all();
        }

    private:
        std::mutex turn;
        std::condition_variable woken;
        std::atomic<int> count{0};
    };

    /// Lasts from a call of `runAll` to the next.
    struct Loop {
        const Item* handle = nullptr;
        std::size_t count = 0;
        std::size_t batch = 1; ///< items that a thread takes at a time
        std::fenv_t mode{};
        std::atomic<std::size_t> next{0};
        std::atomic<bool> isOpen{false};
        std::atomic<int> visitors{0}; ///< other threads that may read the loop
        std::mutex faultTurn;
        std::exception_ptr fault;
    };

    explicit Threads(unsigned count);
    ~Threads();

    void runBoth(const std::function<void()>& other, const std::function<void()>& own);
    void runAll(std::size_t count, const Item& handle);
    void work(std::size_t thread);
    void wake();
    bool takeTask();
    bool visitLoop(std::size_t thread);
    void runItems(std::size_t thread);

    std::atomic<const std::function<void()>*> task{nullptr}; ///< pending
    std::fenv_t taskMode{};
    std::atomic<bool> isTaskDone{false};
    Loop loop;
    std::mutex turn;
    std::atomic<std::uint32_t> wakes{0};
    std::atomic<bool> isStopping{false};
    Sleepers sleepers;
    std::vector<std::thread> others; ///< started last
};

WorkTeam::WorkTeam(unsigned count, unsigned maximumOfCores)
    : threads(std::make_unique<Threads>(
          count > 0 ? count : std::min(std::thread::hardware_concurrency(), maximumOfCores))) {}

WorkTeam::~WorkTeam() = default;

void WorkTeam::runBoth(const std::function<void()>& other, const std::function<void()>& own) {
    threads->runBoth(other, own);
}

void WorkTeam::runAll(std::size_t count, const Item& handle) {
    threads->runAll(count, handle);
}

std::size_t WorkTeam::threadCount() const {
    return threads->others.size() + 1;
}

WorkTeam::Turn::Turn(WorkTeam* sharingTeam) : team(sharingTeam) {
    if (team != nullptr)
        team->threads->turn.lock();
}

WorkTeam::Turn::~Turn() {
    if (team != nullptr)
        team->threads->turn.unlock();
}

WorkTeam::Threads::Threads(unsigned count) {
    for (unsigned other = 1; other < count; ++other)
        others.emplace_back([this, other] { work(other); });
}

WorkTeam::Threads::~Threads() {
    isStopping = true;
    wake();
    for (auto& other : others)
        other.join();
}

void WorkTeam::Threads::wake() {
    ++wakes;
    sleepers.wake();
}

void WorkTeam::Threads::runBoth(const std::function<void()>& other,
                                const std::function<void()>& own) {
    if (others.empty()) {
        other();
        own();
        return;
    }
    std::fegetenv(&taskMode);
    isTaskDone = false;
    task = &other;
    wake();
    const auto finish = [&] {
        if (task.exchange(nullptr) != nullptr)
            other();
        else
            sleepers.waitUntil([&] { return isTaskDone.load(); });
    };
    try {
        own();
    } catch (...) {
        finish();
        throw;
    }
    finish();
}

void WorkTeam::Threads::runAll(std::size_t count, const Item& handle) {
    loop.handle = &handle;
    loop.count = count;
    loop.batch = std::max<std::size_t>(count / (batchesOfThread * (others.size() + 1)), 1);
    loop.next = 0;
    if (others.empty() || count < 2) {
        runItems(0);
    } else {
        std::fegetenv(&loop.mode);
        loop.isOpen = true;
        wake();
        runItems(0);
        // A visitor enters before it looks whether the loop is open, so that none reads it after
        // this.
        loop.isOpen = false;
        sleepers.waitUntil([&] { return loop.visitors == 0; });
    }
    if (loop.fault)
        std::rethrow_exception(std::exchange(loop.fault, nullptr));
}

/// If an item throws, keeps the exception and starts no further items.
void WorkTeam::Threads::runItems(std::size_t thread) {
    try {
        for (std::size_t first = loop.next.fetch_add(loop.batch); first < loop.count;
             first = loop.next.fetch_add(loop.batch))
            for (std::size_t k = first; k < std::min(first + loop.batch, loop.count); ++k)
                (*loop.handle)(k, thread);
    } catch (...) {
        const std::scoped_lock lock(loop.faultTurn);
        loop.fault = std::current_exception();
        loop.next = loop.count;
    }
}

void WorkTeam::Threads::work(std::size_t thread) {
    while (!isStopping) {
        const auto before = wakes.load(); // a later wake ends the wait at once
        if (!takeTask() && !visitLoop(thread))
            sleepers.waitUntil([&] { return wakes != before; });
    }
}

bool WorkTeam::Threads::takeTask() {
    const auto* taken = task.exchange(nullptr);
    if (taken == nullptr)
        return false;
    std::fesetenv(&taskMode);
    (*taken)();
    isTaskDone = true;
    sleepers.wake();
    return true;
}

/// Returns whether this thread has run items.
bool WorkTeam::Threads::visitLoop(std::size_t thread) {
    ++loop.visitors;
    const bool isOpen = loop.isOpen && loop.next < loop.count;
    if (isOpen) {
        std::fesetenv(&loop.mode);
        runItems(thread);
    }
    --loop.visitors;
    sleepers.wake();
    return isOpen;
}

} // namespace idiophone
