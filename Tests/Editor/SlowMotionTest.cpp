#include "Editor/SlowMotion.h"

#include "Editor/ObjectScene.h"
#include "Editor/SurfaceMotion.h"
#include "Support/TestSound.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

ModeNow sounding(float frequencyHz, float amplitude) {
    ModeNow mode;
    mode.frequencyHz = frequencyHz;
    mode.amplitude = amplitude;
    mode.standing = ModeStanding::sounding;
    return mode;
}

/// The largest displacement of a mode within two seconds.
float extentOf(SlowMotion& motion, std::size_t mode) {
    float farthest = 0;
    for (int frame = 0; frame < 60; ++frame) {
        for (const auto& swing : motion.swings())
            if (swing.mode == mode)
                farthest = std::max(farthest, std::abs(swing.displacement));
        motion.advance(1.0 / 30);
    }
    return farthest;
}

} // namespace

TEST_CASE("Of two equally loud modes the lower one shows the larger displacement") {
    SlowMotion motion;
    CHECK(motion.atRest());
    motion.follow(std::array{sounding(200, 0.1f), sounding(800, 0.1f)});
    CHECK(extentOf(motion, 0) == Approx(0.8).epsilon(0.02));
    CHECK(extentOf(motion, 1) == Approx(0.2).epsilon(0.1));
}

TEST_CASE("The shown displacement falls linearly in dB and is 0 at 60 dB below the strike") {
    SlowMotion motion;
    motion.follow(std::array{sounding(300, 0.1f)});
    CHECK(extentOf(motion, 0) == Approx(1).epsilon(0.02));
    motion.follow(std::array{sounding(300, 0.1f * std::pow(10.0f, -1.5f))});
    CHECK(extentOf(motion, 0) == Approx(0.5).epsilon(0.03));
    motion.follow(std::array{sounding(300, 0.00009f)});
    CHECK(motion.atRest());
}

TEST_CASE("Only the eight sounding modes with the largest displacement are shown") {
    SlowMotion motion;
    std::vector<ModeNow> modes;
    for (int i = 0; i < 20; ++i)
        modes.push_back(sounding(100.0f * static_cast<float>(i + 1), 0.1f));
    modes[0].standing = ModeStanding::silenced;
    motion.follow(modes);
    const auto swings = motion.swings();
    REQUIRE(swings.size() == SlowMotion::maximumModes);
    CHECK(swings.front().mode == 1);
    CHECK(swings.back().mode == 8);
    motion.follow({});
    CHECK(motion.atRest());
    motion.advance(1);
    CHECK(motion.swings().empty());
}

TEST_CASE("A mode keeps its phase while other modes start and stop") {
    SlowMotion motion;
    motion.follow(std::array{sounding(200, 0.1f)});
    motion.advance(0.05);
    const float before = motion.swings().front().displacement;
    motion.follow(std::array{sounding(200, 0.1f), sounding(9000, 1e-6f)});
    CHECK(motion.swings().front().displacement == Approx(before).epsilon(1e-3));
}

TEST_CASE("A bar's lowest bending mode moves its middle and its ends in opposite directions") {
    Processor processor;
    const auto played = processor.view().instrument.playedObjects();
    REQUIRE_FALSE(played.empty());
    const auto& object = played.front().object;
    const SurfaceMotion motion(object);
    std::vector<float> displacements(object->vertices.size());
    motion.add(0, 1, displacements);
    float longest = 0, highest = 0, farthest = 0;
    for (std::size_t v = 0; v < object->vertexCount(); ++v) {
        longest = std::max(longest, object->vertices[3 * v]);
        highest = std::max(highest, object->vertices[3 * v + 2]);
        farthest = std::max(farthest, std::hypot(displacements[3 * v], displacements[3 * v + 1],
                                                 displacements[3 * v + 2]));
    }
    CHECK(farthest == Approx(1).epsilon(0.02));
    float middle = 0, end = 0;
    for (std::size_t v = 0; v < object->vertexCount(); ++v) {
        if (object->vertices[3 * v + 2] < 0.9f * highest)
            continue;
        if (std::abs(object->vertices[3 * v]) < 0.1f * longest)
            middle = displacements[3 * v + 2];
        if (object->vertices[3 * v] > 0.98f * longest)
            end = displacements[3 * v + 2];
    }
    CHECK(middle * end < 0);
    CHECK(std::abs(end) > 0.5f);

    // The offsets in the scene have the same length.
    const ObjectScene scene(played);
    const auto offsets = scene.offsetsOf(0, displacements);
    REQUIRE(offsets.size() == scene.objects()[0].vertexCount);
    float most = 0;
    for (const auto& offset : offsets)
        most = std::max(most, std::hypot(offset[0], offset[1], offset[2]));
    CHECK(most == Approx(farthest).epsilon(1e-4));
}

TEST_CASE("The struck places lie on the surface, in the order of the keys") {
    Processor processor;
    const auto played = processor.view().instrument.playedObjects();
    const auto places = processor.view().instrument.struckPlaces(0);
    REQUIRE(places.size() > 2);
    for (std::size_t i = 1; i < places.size(); ++i)
        CHECK(places[i][0] > places[i - 1][0]);
    CHECK(processor.view().instrument.struckPlaces(played.size()).empty());
    const ObjectScene scene(played);
    for (const auto& place : places) {
        auto from = scene.placeOf(0, place);
        from[2] += 1;
        const auto hit = scene.pick(from, {0, 0, -1});
        REQUIRE(hit);
        CHECK(hit->object == 0);
        CHECK(hit->pointMetres[2] == Approx(place[2]).margin(2e-4));
    }
}
