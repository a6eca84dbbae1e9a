#include "Scene/WorkTeam.h"

#include <algorithm>

namespace idiophone {
namespace {

constexpr int pollsBeforeYield = 50'000; // about 0.05 ms
constexpr int yieldsBeforeSleep = 2000;  // about a millisecond
constexpr std::size_t batchesOfThread = 32;
constexpr unsigned maximumOfCores = 4; // more threads would mostly wait

/// Waits for a short time without giving the core away, then lets others run between the polls.
/// Returns false after `yields` of them.
template <class Condition>
bool pollUntil(Condition condition, int yields) {
    for (int poll = 0; poll < pollsBeforeYield; ++poll)
        if (condition())
            return true;
    for (int poll = 0; poll < yields; ++poll) {
        if (condition())
            return true;
        std::this_thread::yield();
    }
    return false;
}

template <class Condition>
void waitUntil(Condition condition) {
    while (!pollUntil(condition, yieldsBeforeSleep)) {
    }
}

} // namespace

WorkTeam::WorkTeam(unsigned threads) {
    const unsigned count =
        threads > 0 ? threads : std::min(std::thread::hardware_concurrency(), maximumOfCores);
    for (unsigned other = 1; other < count; ++other)
        others.emplace_back([this, other] { work(other); });
}

WorkTeam::~WorkTeam() {
    isStopping = true;
    wake();
    for (auto& other : others)
        other.join();
}

void WorkTeam::wake() {
    ++wakes;
    wakes.notify_all();
}

void WorkTeam::runBoth(const std::function<void()>& other, const std::function<void()>& own) {
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
            waitUntil([this] { return isTaskDone.load(); });
    };
    try {
        own();
    } catch (...) {
        finish();
        throw;
    }
    finish();
}

void WorkTeam::runAll(std::size_t count, const Item& handle) {
    loop.handle = &handle;
    loop.count = count;
    loop.batch = std::max<std::size_t>(count / (batchesOfThread * threadCount()), 1);
    loop.next = 0;
    if (others.empty() || count < 2) {
        runItems(0);
        return;
    }
    std::fegetenv(&loop.mode);
    loop.isOpen = true;
    wake();
    runItems(0);
    // A visitor enters before it looks whether the loop is open, so that none reads it after this.
    loop.isOpen = false;
    waitUntil([this] { return loop.visitors == 0; });
}

void WorkTeam::runItems(std::size_t thread) {
    for (std::size_t first = loop.next.fetch_add(loop.batch); first < loop.count;
         first = loop.next.fetch_add(loop.batch))
        for (std::size_t k = first; k < std::min(first + loop.batch, loop.count); ++k)
            (*loop.handle)(k, thread);
}

void WorkTeam::work(std::size_t thread) {
    while (!isStopping) {
        const auto before = wakes.load(); // a later wake ends the wait at once
        if (takeTask() || visitLoop(thread))
            continue;
        if (!pollUntil([&] { return wakes != before; }, yieldsBeforeSleep))
            wakes.wait(before);
    }
}

bool WorkTeam::takeTask() {
    const auto* taken = task.exchange(nullptr);
    if (taken == nullptr)
        return false;
    std::fesetenv(&taskMode);
    (*taken)();
    isTaskDone = true;
    return true;
}

/// Returns whether this thread has run items.
bool WorkTeam::visitLoop(std::size_t thread) {
    ++loop.visitors;
    const bool isOpen = loop.isOpen && loop.next < loop.count;
    if (isOpen) {
        std::fesetenv(&loop.mode);
        runItems(thread);
    }
    --loop.visitors;
    return isOpen;
}

} // namespace idiophone
