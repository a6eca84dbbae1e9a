// Tests a hand that drags over a surface.
#include "Instrument/HandScrape.h"
#include "Instrument/FactoryContent.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/Player.h"
#include "Support/AllocationCounter.h"
#include "Support/Highs.h"
#include "Support/KeyedPresets.h"
#include "Support/Larger.h"
#include "Support/Level.h"
#include "Support/RenderNotes.h"
#include "TestInstruments.h"
#include "World/ObjectSurface.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double rateHz = 48000;
constexpr int eventSamples = 800; // 60 of them a second

/// A square of one metre that rings for about ten milliseconds.
std::shared_ptr<const Instrument> shortSquare() {
    auto object = syntheticObject({300, 810, 1600, 2700});
    object.material.damping.fluidPerSecond = 1000;
    return keysOn(std::move(object), KeyMapKind::zones, 48, 72);
}

ParameterValues quiet() {
    ParameterValues parameters;
    parameters.set(ParameterId::tau, 0.001);
    parameters.set(ParameterId::letRing, 1);
    return parameters;
}

SurfaceTouch touchAt(const Instrument& instrument, double x, double y, double pressure = 1) {
    const ObjectSurface surface(*instrument.slots()[0].object);
    return {.slot = 0, .point = surface.nearest({x, y, 0}), .pressure = pressure};
}

/// Returns the left channel while the hand moves along x at a speed.
std::vector<float> drag(Player& player,
                        double& x,
                        double metresPerSecond,
                        double seconds,
                        const ParameterValues& parameters = quiet()) {
    std::vector<float> output;
    const int events = static_cast<int>(seconds * rateHz) / eventSamples;
    for (int event = 0; event < events; ++event) {
        x += metresPerSecond * eventSamples / rateHz;
        player.scrapeSurface(touchAt(player.instrument(), x, 0.4));
        const auto sound = renderStereo(player, {}, eventSamples, 100, parameters);
        output.insert(output.end(), sound.left.begin(), sound.left.end());
    }
    return output;
}

std::array<double, 3> metresOf(const ModalObject& object, const StrikePoint& point) {
    std::array<double, 3> metres{};
    for (std::size_t k = 0; k < maximumShapeRows; ++k) {
        const auto vertex = object.shapeVertices[static_cast<std::size_t>(point.shapeRows[k])];
        for (std::size_t axis = 0; axis < 3; ++axis)
            metres[axis] += static_cast<double>(
                point.weights[k] * object.vertices[3 * static_cast<std::size_t>(vertex) + axis]);
    }
    return metres;
}

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Returns a second of a hand that moves to and fro over the object of a key at 0.5 m/s. On a small
/// object it makes at most about four passes, because faster motion would leap at each event.
std::vector<float> scrapedToAndFro(Player& player, const Key& key, const Preset& preset) {
    const auto& strip = *key.strip;
    const auto& slot = player.instrument().slots()[static_cast<std::size_t>(key.slot)];
    const auto placeAt = [&](double along) { return strip.between(along, 0).point; };
    const double lengthMetres =
        slot.sizeRatio * preset.parameters[ParameterId::size] / 0.6 *
        distance(metresOf(*slot.object, placeAt(0.2)), metresOf(*slot.object, placeAt(0.8)));
    std::vector<float> output;
    double along = 0.2, step = std::min(0.5 * eventSamples / rateHz / lengthMetres, 0.08);
    for (int event = 0; event < 60; ++event) {
        if (along + step > 0.8 || along + step < 0.2)
            step = -step;
        along += step;
        player.scrapeSurface(
            {.slot = static_cast<std::size_t>(key.slot), .point = placeAt(along), .pressure = 0.5});
        const auto sound = renderStereo(player, {}, eventSamples, 100, preset.parameters);
        output.insert(output.end(), sound.left.begin(), sound.left.end());
    }
    return output;
}

} // namespace

TEST_CASE("Every factory instrument is audible beside strikes when a hand scrapes it") {
    for (const auto& preset : keyedFactoryPresets()) {
        if (!strikes(preset.parameters))
            continue;
        const auto instrument = Instrument::build(preset.keyMap, ObjectLibrary::shared()).value();
        const auto& map = preset.keyMap;
        for (const double part : {0.1, 0.5, 0.9}) {
            const int note =
                map.lowestNote + static_cast<int>(part * (map.highestNote - map.lowestNote));
            const auto& key = instrument->key(note);
            const auto newPlayer = [&] {
                return Player(instrument, rateHz, preset.surface, preset.seed, preset.parameters);
            };
            auto player = newPlayer();
            const auto scraped = scrapedToAndFro(player, key, preset);
            auto other = newPlayer();
            other.strikeSurface({.slot = static_cast<std::size_t>(key.slot),
                                 .point = key.strip->between(0.4, 0).point,
                                 .velocity = 80});
            const auto struck =
                renderStereo(other, {}, scraped.size(), 100, preset.parameters).left;
            INFO(preset.name << ", note " << note);
            const double decibels = 20 * std::log10(rms(scraped) / rms(struck));
            CHECK(decibels > -20);
            CHECK(decibels < 7); // on rings along an edge, where rounding chooses the side
            CHECK(peak(scraped) < 1.1f * peak(struck));
        }
    }
}

TEST_CASE("A drag over the surface sounds with any key contact, and faster drags are louder") {
    auto parameters = quiet();
    parameters.set(ParameterId::contact, GENERATE(strikeContact, scrapeContact, rollContact));
    const auto levelAt = [&](double metresPerSecond) {
        Player player(shortSquare(), rateHz);
        double x = 0.05;
        const auto sound = drag(player, x, metresPerSecond, 0.8, parameters);
        return rms(std::span(sound).last(24000));
    };
    const double slow = levelAt(0.25), fast = levelAt(0.8);
    CHECK(slow > 1e-6);
    CHECK(fast > 1.3 * slow);
}

TEST_CASE("A higher contact force or hand pressure makes a scrape louder") {
    const auto levelAt = [&](double newtons) {
        auto parameters = quiet();
        parameters.set(ParameterId::contactForce, newtons);
        Player player(shortSquare(), rateHz);
        double x = 0.05;
        const auto sound = drag(player, x, 0.5, 0.5, parameters);
        return rms(std::span(sound).last(12000));
    };
    const double light = levelAt(1), heavy = levelAt(4);
    CHECK(std::abs(heavy / light - 2) < 0.01); // √F
}

TEST_CASE("A hand at rest on the surface is silent, and a hand that stops falls silent") {
    Player player(shortSquare(), rateHz);
    double x = 0.2;
    CHECK(peak(drag(player, x, 0, 0.5)) == 0);
    const auto moving = drag(player, x, 0.5, 0.5);
    CHECK(rms(moving) > 1e-6);
    const auto stopped = drag(player, x, 0, 0.5);
    CHECK(peak(std::span(stopped).last(12000)) < 1e-3f * peak(moving));
    CHECK_FALSE(player.silent()); // the hand still holds the object
    CHECK(rms(drag(player, x, 0.5, 0.5)) > 0.3 * rms(moving));
}

TEST_CASE("The speed is smooth between the events of a mouse") {
    // In the middle of a steady drag with 60 steps a second, the 60 Hz pulses stay small.
    SurfacePath path;
    path.begin({}, {0, 0, 0});
    double least = 1e9, most = 0;
    for (int cell = 0; cell < 1500; ++cell) {
        if (cell % 12 == 0)
            path.extendTo({}, {0.5 * cell * cellSamples / rateHz, 0, 0});
        const double speed = path.advance(cellSamples / rateHz, 5);
        if (cell > 200) {
            least = std::min(least, speed);
            most = std::max(most, speed);
        }
    }
    CHECK(least > 0.45);
    CHECK(most < 0.55);
}

TEST_CASE("A path is followed to its end without overshoot, and no faster than allowed") {
    SurfacePath path;
    StrikePoint corner;
    path.begin(corner, {0, 0, 0});
    corner.shapeRows[0] = 1;
    path.extendTo(corner, {1, 0, 0});
    corner.shapeRows[0] = 2;
    path.extendTo(corner, {1, 1, 0});
    path.extendTo(corner, {1, 1, 0}); // already the end of the path
    double lastWay = -1;
    std::int32_t from = 0;
    for (int cell = 0; cell < 3000; ++cell) {
        CHECK(path.advance(cellSamples / rateHz, 2) <= 2);
        const ForcePlace place = path.place(0.5);
        if (place.points[0].point.shapeRows[0] != from) {
            from = place.points[0].point.shapeRows[0];
            lastWay = -1;
        }
        CHECK(double(place.fraction) >= lastWay);
        lastWay = double(place.fraction);
    }
    CHECK(from == 1);
    CHECK(lastWay == 1);
    CHECK(path.place(0.5).points[1].direction == std::array<float, 3>{0, 0.5f, -1});
}

TEST_CASE("Corners beyond the capacity move the last one, and the hand arrives there") {
    SurfacePath path;
    path.begin({}, {0, 0, 0});
    StrikePoint end;
    end.shapeRows[0] = 7;
    for (int k = 1; k <= 1000; ++k)
        path.extendTo(end, {0.001 * k, 0.001 * (k % 2), 0});
    double speed = 1;
    for (int cell = 0; cell < 3000; ++cell)
        speed = path.advance(cellSamples / rateHz, 5);
    CHECK(speed == 0);
    CHECK(path.place(0).points[1].point == end);
    CHECK(path.place(0).fraction == 1);
}

TEST_CASE("A lifted hand fades within 10 ms without a click and leaves silence") {
    const auto instrument = plate();
    auto parameters = quiet();
    parameters.set(ParameterId::contactForce, 20);
    const auto highsAfter = [&](bool lifts) {
        Player player(instrument, rateHz);
        const auto& object = *instrument->slots()[0].object;
        const ObjectSurface surface(object);
        std::vector<float> output;
        for (int event = 0; event < 60; ++event) {
            if (lifts && event >= 40)
                player.scrapeSurface({.slot = 0, .point = surface.nearest({}), .pressure = 0});
            else
                player.scrapeSurface(
                    {.slot = 0,
                     .point = surface.nearest({0.15 * std::sin(0.13 * event), 0.05, 1}),
                     .pressure = 1});
            const auto sound = renderStereo(player, {}, eventSamples, 160, parameters);
            output.insert(output.end(), sound.left.begin(), sound.left.end());
        }
        return loudestHighsDb(std::span(output).subspan(39 * eventSamples, 3 * eventSamples),
                              rateHz);
    };
    const double heldDb = highsAfter(false), liftedDb = highsAfter(true);
    CAPTURE(heldDb, liftedDb);
    CHECK(liftedDb < heldDb + 3);

    Player player(shortSquare(), rateHz);
    double x = 0.1;
    drag(player, x, 0.5, 0.3);
    player.scrapeSurface(touchAt(player.instrument(), x, 0.4, 0));
    renderStereo(player, {}, 9600, 480, quiet());
    CHECK(player.silent());
}

TEST_CASE("The same touches give the same bits in blocks of any size") {
    const auto instrument = plate();
    const auto played = [&](std::size_t blockSize) {
        Player player(instrument, rateHz);
        const ObjectSurface surface(*instrument->slots()[0].object);
        std::vector<float> output;
        for (int event = 0; event < 20; ++event) {
            player.scrapeSurface({.slot = 0,
                                  .point = surface.nearest({0.01 * event, 0.002 * event, 1}),
                                  .pressure = event < 15 ? 1.0 : 0.0});
            const auto sound =
                renderStereo(player, {midi(0, 0x90, 60, 80)}, eventSamples, blockSize, quiet());
            output.insert(output.end(), sound.left.begin(), sound.left.end());
        }
        return output;
    };
    const auto expected = played(eventSamples);
    CHECK(peak(expected) > 0);
    for (const std::size_t blockSize : {1, 64, 100, 799})
        CHECK(played(blockSize) == expected);
}

TEST_CASE("A hand that touches another object leaves the first one") {
    const auto instrument = bars();
    Player player(instrument, rateHz);
    const auto drag = [&](std::size_t slot) {
        for (int event = 0; event < 30; ++event) {
            player.scrapeSurface({.slot = slot,
                                  .point = ObjectSurface(*instrument->slots()[slot].object)
                                               .nearest({0.02 * event, 0.5, 0}),
                                  .pressure = 1});
            renderStereo(player, {}, eventSamples, 480, quiet());
        }
    };
    drag(3);
    CHECK(player.slotPlayedLast() == 3);
    CHECK(player.synthesiser().status()[3].amplitude > 0);
    drag(7);
    CHECK(player.slotPlayedLast() == 7);
    CHECK(player.synthesiser().status()[7].amplitude > 0);
    auto damped = quiet();
    damped.set(ParameterId::letRing, 0);
    damped.set(ParameterId::releaseTime, 0.02);
    renderStereo(player, {}, 9600, 480, damped);
    CHECK(player.synthesiser().status()[3].amplitude == 0);
}

TEST_CASE("Touches of missing slots or rows are ignored, and extreme ones are bounded") {
    const auto instrument = shortSquare();
    Player player(instrument, rateHz);
    auto touch = touchAt(*instrument, 0.5, 0.5);
    touch.slot = 5;
    player.scrapeSurface(touch);
    touch = touchAt(*instrument, 0.5, 0.5);
    touch.point.shapeRows[0] = 4;
    player.scrapeSurface(touch);
    CHECK(player.silent());
    touch = touchAt(*instrument, 0.5, 0.5, std::nan(""));
    player.scrapeSurface(touch);
    CHECK(player.silent());

    std::vector<SurfaceTouch> wild;
    for (int k = 0; k < 1000; ++k)
        wild.push_back(touchAt(*instrument, k % 2, k % 3, k % 7 == 0 ? 0 : 1e300));
    const AllocationCounter allocations;
    for (const auto& wildTouch : wild)
        player.scrapeSurface(wildTouch);
    CHECK(allocations.allocations() == 0);
    const auto sound = renderStereo(player, {}, 9600, 480, quiet());
    for (const float sample : sound.left)
        REQUIRE(std::isfinite(sample));
}

TEST_CASE("All Notes Off lifts the hand, and a reset forgets it") {
    Player player(shortSquare(), rateHz);
    double x = 0.1;
    drag(player, x, 0.5, 0.2);
    renderStereo(player, {midi(0, 0xb0, 123, 0)}, 9600, 480, quiet());
    CHECK(player.silent());
    drag(player, x, 0.5, 0.2);
    player.reset();
    CHECK(player.silent());
}

TEST_CASE("A hand lifted by All Sound Off is not heard during the next note") {
    Player player(shortSquare(), rateHz), alone(shortSquare(), rateHz);
    double x = 0.1;
    const auto scraped = drag(player, x, 1, 0.2);
    auto parameters = quiet();
    parameters.set(ParameterId::strikeSpread, 0);
    const auto next = midi(0, 0x90, 60, 1);
    const auto sound = render(player, {midi(0, 0xb0, 120, 0), next}, 4800, 480, parameters);
    const auto expected = render(alone, {next}, 4800, 480, parameters);
    float most = 0;
    for (std::size_t i = 2 * cellSamples; i < sound.size(); ++i)
        most = larger(most, std::abs(sound[i] - expected[i]));
    CHECK(most < 1e-6f * peak(scraped));
}

TEST_CASE("Silenced modes of an object are silenced in every slot that shares it") {
    const auto instrument = keysOn(syntheticObject({300, 810, 1600}), KeyMapKind::scaled, 60, 62);
    Player player(instrument, rateHz), plain(instrument, rateHz);
    player.setSilencedModes(
        {.objects = {{.object = instrument->slots()[0].object.get(), .isSilenced = {0, 1, 0}}}});
    const std::vector<MidiEvent> notes{midi(0, 0x90, 60, 90), midi(0, 0x90, 62, 90)};
    renderStereo(player, notes, 4800, 480, quiet());
    renderStereo(plain, notes, 4800, 480, quiet());
    for (const std::size_t slot : {0, 2}) {
        CHECK(plain.synthesiser().status()[slot].modesMixed == 3);
        CHECK(player.synthesiser().status()[slot].modesMixed == 2);
    }
    player.setSilencedModes({});
    renderStereo(player, {}, 480, 480, quiet());
    CHECK(player.synthesiser().status()[0].modesMixed == 3);
}
