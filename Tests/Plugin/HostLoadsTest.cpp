#include "Plugin/HostLoads.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;

namespace {

Sound named(const char* name) {
    Sound sound;
    sound.preset.name = name;
    return sound;
}

} // namespace

TEST_CASE("Consecutive programs of MIDI keep the sound before the first, which is taken once") {
    HostLoads loads;
    CHECK_FALSE(loads.takeBeforePrograms());
    loads.keepBeforePrograms(named("first"));
    loads.keepBeforePrograms(named("second"));
    const auto before = loads.takeBeforePrograms();
    REQUIRE(before);
    CHECK(before->preset.name == "first");
    CHECK_FALSE(loads.takeBeforePrograms());
    loads.keepBeforePrograms(named("third"));
    CHECK(loads.takeBeforePrograms()->preset.name == "third");
    CHECK(loads.counted() == 0);
}

TEST_CASE("A load by the host is counted and drops the sound before MIDI's programs") {
    HostLoads loads;
    loads.keepBeforePrograms(named("first"));
    loads.count();
    CHECK(loads.counted() == 1);
    CHECK_FALSE(loads.takeBeforePrograms());
    loads.count();
    CHECK(loads.counted() == 2);
}
