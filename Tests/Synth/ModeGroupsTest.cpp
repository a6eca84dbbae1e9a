#include "ResonatorParts.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

GroupConditions damped(double fluidPerSecond) {
    return {.law = {.damping = {.fluidPerSecond = fluidPerSecond}}};
}

} // namespace

TEST_CASE("Groups follow the poles only when asked, and their shares sum to 1") {
    ResonatorParts parts(ringingObject({1000, 1002, 1900}, 1));
    ModeGroups& groups = parts.groups;
    REQUIRE(groups.size() == 3);
    groups.set(damped(60));
    CHECK(groups.areBehind());
    CHECK(groups.size() == 3);
    CHECK(groups.follow());
    CHECK(!groups.areBehind());
    REQUIRE(groups.size() == 2);
    CHECK(groups.starts()[1] == 2);
    CHECK(!groups.follow());
    groups.set(damped(1));
    REQUIRE(groups.follow());
    REQUIRE(groups.size() == 3);
    double sum = 0;
    for (const ModeShare& share : groups.shares())
        sum += share.share;
    CHECK(std::abs(sum - 2) < 1e-12);
}

TEST_CASE("A silenced mode is inaudible and shares no group with audible modes") {
    ResonatorParts parts(ringingObject({1000, 1002, 1900}, 1));
    ModeGroups& groups = parts.groups;
    const std::vector<std::uint8_t> silenced{1, 0, 0};
    CHECK(groups.requestSilenced(silenced));
    CHECK(!groups.requestSilenced(silenced));
    CHECK(groups.differFrom(groups.conditions()));
    groups.set(damped(60));
    groups.follow();
    REQUIRE(groups.size() == 3);
    CHECK(!groups.audible(0));
    CHECK(groups.audible(1));
    CHECK(groups.silences()[0] == 1);
    CHECK(groups.requestSilenced({}));
    groups.set(damped(60));
    groups.follow();
    CHECK(groups.size() == 2);
    CHECK(groups.silences().empty());
}

TEST_CASE("Merged residues of equal poles add up") {
    ResonatorParts parts(ringingObject({1000, 1000, 1900}, 1));
    parts.groups.set(damped(60));
    parts.groups.follow();
    REQUIRE(parts.groups.size() == 2);
    ChannelResidues merged;
    merged.resize(modeBlock);
    const std::vector<std::complex<float>> modes{{1, 2}, {3, -1}, {5, 0}};
    parts.groups.merge(modes, merged);
    CHECK(merged.re[0] == 4.0f);
    CHECK(merged.im[0] == 1.0f);
    CHECK(merged.re[1] == 5.0f);
}
