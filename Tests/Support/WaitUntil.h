// Waits for events of other threads.
#pragma once

#include <catch2/catch_test_macros.hpp>
#include <chrono>
#include <thread>

namespace idiophone::test {

/// Calls `step` until the condition holds, however long that takes. The time limit only ends a
/// failing test.
template <class Condition, class Step>
void waitUntil(const Condition& holds, const Step& step) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(10);
    while (!holds()) {
        REQUIRE(std::chrono::steady_clock::now() < end);
        step();
        std::this_thread::sleep_for(std::chrono::milliseconds(1)); // leaves the core to the others
    }
}

template <class Condition>
void waitUntil(const Condition& holds) {
    waitUntil(holds, [] {});
}

} // namespace idiophone::test
