#include "Instrument/ObjectLibrary.h"
#include "Support/SyntheticObject.h"

#include <catch2/catch_test_macros.hpp>
#include <thread>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;

TEST_CASE("Threads that ask for an object share it, at the same time or later") {
    for (int round = 0; round < 20; ++round) {
        ObjectLibrary library;
        std::vector<std::shared_ptr<const ModalObject>> found(4);
        std::vector<std::thread> threads;
        for (auto& object : found)
            threads.emplace_back([&] { object = library.find("plate").value(); });
        for (auto& thread : threads)
            thread.join();
        for (const auto& object : found)
            CHECK(object == found.front());
        CHECK(library.find("plate").value() == found.front());
    }
}

TEST_CASE("An object without a name is not searched among files") {
    ObjectLibrary library;
    CHECK(library.find("").error().message == "no object is named");
}

TEST_CASE("An added object has precedence over the factory while it is held") {
    ObjectLibrary library;
    auto own = library.add("plate", syntheticObject({100}));
    CHECK(library.find("plate").value() == own);
    own.reset();
    CHECK(library.find("plate").value()->name != "synthetic");
}

TEST_CASE("A library in front of another keeps its own objects and asks the other for the rest") {
    ObjectLibrary others;
    ObjectLibrary own(others);
    const auto added = own.add("plate", syntheticObject({100}));
    CHECK(own.find("plate").value() == added);
    CHECK(others.find("plate").value()->name != "synthetic");
    const auto ring = own.find("ring").value();
    CHECK(others.find("ring").value() == ring);
    CHECK_FALSE(own.find("no such object"));
}

TEST_CASE("A missing object is an error on every request") {
    ObjectLibrary library;
    for (int round = 0; round < 3; ++round)
        CHECK_FALSE(library.find("no such object"));
}
