#include "Instrument/LatestValue.h"

#include <catch2/catch_test_macros.hpp>
#include <thread>

using namespace idiophone;

TEST_CASE("The newest published value is read once") {
    LatestValue<int> latest(0);
    CHECK(latest.take() == nullptr);
    latest.next() = 1;
    CHECK(latest.take() == nullptr);
    latest.publish();
    latest.next() = 2;
    latest.publish();
    latest.next() = 3;
    const int* newest = latest.take();
    REQUIRE(newest != nullptr);
    CHECK(*newest == 2);
    CHECK(latest.take() == nullptr);
    latest.publish();
    CHECK(*latest.take() == 3);
}

TEST_CASE("Between two threads values arrive complete and in order") {
    using Many = std::array<int, 1000>;
    LatestValue<Many> latest(Many{});
    constexpr int last = 20000;
    std::thread writer([&] {
        for (int value = 1; value <= last; ++value) {
            latest.next().fill(value);
            latest.publish();
        }
    });
    int seen = 0;
    bool inOrder = true, whole = true;
    while (seen < last)
        if (const Many* value = latest.take()) {
            inOrder = inOrder && value->front() > seen;
            seen = value->front();
            for (const int part : *value)
                whole = whole && part == seen;
        }
    writer.join();
    CHECK(inOrder);
    CHECK(whole);
}
