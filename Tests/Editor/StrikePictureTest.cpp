// Tests of what strikes look like: mallets, lights and the outline under the mouse.
#include "Editor/HoverOutline.h"
#include "Editor/MalletSwings.h"
#include "Editor/ObjectHand.h"
#include "Editor/StrikeGlows.h"
#include "Editor/StrikeWatch.h"

#include <array>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <vector>

using namespace idiophone;
using Catch::Approx;

namespace {

constexpr float head = 0.01f, stick = 0.4f;
constexpr ScenePlace up{0, 0, 1};

} // namespace

TEST_CASE("A mallet touches the struck place, rises above it and leaves") {
    MalletSwings swings;
    CHECK_FALSE(swings.moves());
    swings.strike({0.1f, 0.2f, 0.3f}, up, 1);
    const auto touching = swings.mallets(head, stick);
    REQUIRE(touching.size() == 1);
    CHECK(touching[0].head[0] == Approx(0.1f));
    CHECK(touching[0].head[2] == Approx(0.3f + head)); // the head rests on the surface
    CHECK(touching[0].stick[1] < -0.5f);               // the hand is on the player's side
    CHECK(touching[0].stick[2] > 0);
    float last = touching[0].head[2];
    for (double seconds = 0; seconds < 0.4; seconds += 0.1) {
        swings.advance(0.1);
        const float height = swings.mallets(head, stick)[0].head[2];
        CHECK(height > last);
        last = height;
    }
    CHECK(last > 0.3f + 0.2f * stick);
    swings.advance(MalletSwings::swingSeconds);
    CHECK_FALSE(swings.moves());
}

TEST_CASE("A harder strike throws the mallet higher") {
    const auto heightAfter = [](float strength) {
        MalletSwings swings;
        swings.strike({}, up, strength);
        swings.advance(0.2);
        return swings.mallets(head, stick)[0].head[2];
    };
    CHECK(heightAfter(1) > 1.5f * heightAfter(0.1f));
}

TEST_CASE("A mallet strikes a wall from outside") {
    MalletSwings swings;
    swings.strike({}, {0, 1, 0}, 1); // the far side of a bell
    const auto mallet = swings.mallets(head, stick)[0];
    CHECK(mallet.head[1] == Approx(head));
    CHECK(mallet.stick[1] > 0);
}

TEST_CASE("Strikes at once have a mallet each, and a later one takes the first again") {
    MalletSwings swings;
    for (const float x : {0.0f, 0.1f, 0.2f})
        swings.strike({x, 0, 0}, up, 1);
    CHECK(swings.mallets(head, stick).size() == 3);
    swings.advance(0.3);
    swings.strike({0.5f, 0, 0}, up, 1);
    const auto mallets = swings.mallets(head, stick);
    REQUIRE(mallets.size() == 3);
    CHECK(mallets.back().head[0] == Approx(0.5f));
    for (int strike = 0; strike < 20; ++strike)
        swings.strike({}, up, 1);
    CHECK(swings.mallets(head, stick).size() == MalletSwings::maximumMallets);
}

TEST_CASE("A light spreads from the struck place and fades with the sound") {
    StrikeGlows glows;
    glows.reset({0.1f, 0.2f}, false);
    CHECK_FALSE(glows.moves());
    glows.strike(1, {0.5f, 0, 0});
    CHECK(glows.follow(std::array{0.0f, 0.9f}));
    CHECK_FALSE(glows.follow(std::array{0.0f, 0.9f}));
    const auto atFirst = glows.glows();
    CHECK(atFirst[0].brightness == 0);
    CHECK(atFirst[1].brightness == Approx(1));
    CHECK(atFirst[1].place[0] == 0.5f);
    CHECK(atFirst[1].metres < 0.05f);
    glows.advance(0.5);
    const auto later = glows.glows();
    CHECK(later[1].metres > 0.2f); // all of the object
    CHECK(later[1].brightness < atFirst[1].brightness);
    glows.follow(std::array{0.0f, 0.3f});
    CHECK(glows.glows()[1].brightness < later[1].brightness);
    glows.advance(5);
    CHECK_FALSE(glows.moves());
    glows.follow(std::array{0.0f, 0.0f});
    CHECK(glows.glows()[1].brightness == 0);
    CHECK_FALSE(glows.sounds());
}

TEST_CASE("A strike is a slot that has become much louder") {
    StrikeWatch watch;
    const auto struck = [&](std::vector<SlotNow> slots) { return watch.follow(slots).size(); };
    const auto slot = [](int note, float amplitude) {
        return SlotNow{.object = 0, .note = note, .amplitude = amplitude};
    };
    CHECK(struck({slot(60, 0.1f)}) == 1);
    CHECK(struck({slot(60, 0.09f)}) == 0);
    CHECK(struck({slot(60, 0.095f)}) == 0);
    CHECK(struck({slot(60, 0.2f), slot(62, 0.1f)}) == 2);
    CHECK(struck({}) == 0);
    CHECK(struck({slot(60, 0.01f)}) == 1);
}

TEST_CASE("The velocity of a click rises towards the player and with the mouse's speed") {
    const auto velocity = [](double towardsPlayer, double speed) {
        return ObjectHand::velocityOf({.towardsPlayer = towardsPlayer}, speed);
    };
    CHECK(velocity(0, 0) == 45);
    CHECK(velocity(1, 0) == 127);
    CHECK(velocity(0.5, 0) == 86);
    CHECK(velocity(0.5, 1e6) == 127);
}

TEST_CASE("The text under the mouse has the note of an object with one key") {
    CHECK(HoverOutline::textOf({.object = 0, .note = 72, .velocity = 96}) == "C5, velocity 96");
    CHECK(HoverOutline::textOf({.object = 0, .note = -1, .velocity = 45}) == "velocity 45");
    HoverOutline outline;
    CHECK(outline.show(HoverOutline::Hover{.object = 1}));
    CHECK_FALSE(outline.show(HoverOutline::Hover{.object = 1}));
    CHECK(outline.show(std::nullopt));
}
