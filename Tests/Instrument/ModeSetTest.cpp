#include "Instrument/ModeSet.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;

TEST_CASE("Modes are added and removed object by object") {
    ModeSet set;
    CHECK(set.set("a", 3, true));
    CHECK(set.set("a", 3, true));
    CHECK(set.set("a", 0, true));
    CHECK(set.set("b", 3, true));
    CHECK(set.size() == 3);
    CHECK(set.contains("a", 0));
    CHECK_FALSE(set.contains("b", 0));
    CHECK(set.set("b", 3, false));
    CHECK(set.set("b", 3, false));
    CHECK(set.objects().size() == 1);
    set.clear("a");
    set.clear("c");
    CHECK(set.empty());
    CHECK(set.size() == 0);
    CHECK(set == ModeSet());
}

TEST_CASE("A full set takes no more modes, and no set takes an invalid number") {
    ModeSet set;
    CHECK_FALSE(set.set("a", -1, true));
    CHECK_FALSE(set.set("a", ModeSet::maximumModes, true));
    CHECK(set.empty());
    for (std::int32_t mode = 0; mode < std::int32_t{ModeSet::capacity}; ++mode)
        REQUIRE(set.set(mode % 2 == 0 ? "a" : "b", mode, true));
    CHECK_FALSE(set.set("c", 0, true));
    CHECK(set.size() == ModeSet::capacity);
    CHECK(set.set("a", 0, false));
    CHECK(set.set("c", 0, true));
}
