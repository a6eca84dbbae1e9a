// Tests scenes as instruments, whose notes set bodies in motion.
#include "Scene/SceneStage.h"
#include "Instrument/ObjectLibrary.h"

#include "Instrument/Player.h"
#include "Scene/FactoryScenes.h"
#include "Scene/SceneText.h"
#include "Scene/SilentBody.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <functional>

using namespace idiophone;
using Catch::Matchers::WithinAbs;

namespace {

constexpr double rate = 48000;

std::shared_ptr<const Instrument> sceneInstrument(const std::string& name) {
    return buildInstrument({.kind = KeyMapKind::scene, .object = name}, ObjectLibrary::shared())
        .value();
}

struct Note {
    double seconds = 0;
    int note = 72;
    int velocity = 100;
};

/// Returns the left channel followed by the right one.
std::vector<float> play(
    Player& player,
    const std::vector<Note>& notes,
    double seconds,
    int block,
    const std::function<void(Player&)>& beforeBlock = [](Player&) {}) {
    const auto total = static_cast<std::size_t>(seconds * rate);
    std::vector<float> left(total), right(total);
    const ParameterValues values;
    for (std::size_t start = 0; start < total; start += static_cast<std::size_t>(block)) {
        const auto count = std::min(static_cast<std::size_t>(block), total - start);
        std::vector<MidiEvent> events;
        for (const auto& note : notes) {
            const double at = note.seconds * rate - static_cast<double>(start);
            if (at >= 0 && at < static_cast<double>(count))
                events.push_back({static_cast<int>(at),
                                  {0x90, static_cast<std::uint8_t>(note.note),
                                   static_cast<std::uint8_t>(note.velocity)}});
        }
        beforeBlock(player);
        player.process(
            {std::span(left).subspan(start, count), std::span(right).subspan(start, count)}, events,
            values);
    }
    left.insert(left.end(), right.begin(), right.end());
    return left;
}

/// Returns the time at which a sound first exceeds a hundredth of its peak.
double onsetSeconds(const std::vector<float>& sound) {
    float peak = 0;
    for (const float x : sound)
        peak = std::max(peak, std::abs(x));
    const auto first =
        std::ranges::find_if(sound, [&](float x) { return std::abs(x) > 0.01f * peak; });
    return static_cast<double>(first - sound.begin()) / rate;
}

/// Returns the maximum third difference in the left channel within 300 samples. It is large at a
/// cut, and small while the sound rings or fades.
double kinkFrom(const std::vector<float>& sound, std::size_t first) {
    double largest = 0;
    for (std::size_t i = first; i < first + 300; ++i)
        largest = std::max(largest, std::abs(static_cast<double>(sound[i]) - 3 * sound[i - 1] +
                                             3 * sound[i - 2] - sound[i - 3]));
    return largest;
}

/// Returns the left channel's maximum from a time on.
float tailLevel(const std::vector<float>& sound, double seconds) {
    float level = 0;
    for (auto i = static_cast<std::size_t>(seconds * rate); i < sound.size() / 2; ++i)
        level = std::max(level, std::abs(sound[i]));
    return level;
}

} // namespace

TEST_CASE("A die hits its bar after the scene's delay, from any height") {
    const auto instrument = sceneInstrument("Dice on a xylophone");
    const double delay = instrument->stage()->delaySeconds();
    CHECK_THAT(delay, WithinAbs(std::sqrt(2 / 9.81), 1e-9)); // one metre
    for (const int velocity : {1, 64, 127}) {
        Player player(instrument, rate);
        player.stage().setOffline(true);
        const auto sound = play(player, {{0.1003, 72, velocity}}, 1, 256);
        CHECK_THAT(onsetSeconds(sound), WithinAbs(0.1003 + delay, 0.002));
        CHECK(player.stage().lateEvents() == 0);
    }
}

TEST_CASE("A scene instrument sounds the same for all block sizes and after a reset") {
    const auto instrument = sceneInstrument("Dice on a xylophone");
    const std::vector<Note> notes{{0.05, 72, 90}, {0.06, 79, 120}, {0.4, 84, 30}, {0.41, 72, 127}};
    Player player(instrument, rate);
    player.stage().setOffline(true);
    const auto first = play(player, notes, 1.5, 512);
    CHECK(std::ranges::any_of(first, [](float x) { return x != 0; }));
    player.reset();
    CHECK(play(player, notes, 1.5, 512) == first);
    Player other(instrument, rate);
    other.stage().setOffline(true);
    CHECK(play(other, notes, 1.5, 37) == first);
}

TEST_CASE("In real time a stage sounds as offline if the caller waits for the simulation") {
    const auto instrument = sceneInstrument("Cylinder off a table");
    const std::vector<Note> notes{{0, 60, 64}, {0.3, 60, 100}};
    Player offline(instrument, rate), player(instrument, rate);
    offline.stage().setOffline(true);
    const auto expected = play(offline, notes, 1, 64);
    const auto sound =
        play(player, notes, 1, 64, [](Player& waiting) { waiting.stage().waitForSimulation(); });
    CHECK((sound == expected));
    CHECK(player.stage().lateEvents() == 0);
}

TEST_CASE("Impacts and contacts that come late are counted and still sound") {
    auto scraped = *findFactoryScene("Bell under a hand");
    scraped.hand->taps.clear();
    for (auto& moment : scraped.hand->path)
        moment.seconds -= 2.5; // so that the contact begins after 0.1 s
    for (auto scene : {*findFactoryScene("Dice on a xylophone"), scraped}) {
        INFO(scene.name);
        // Bodies far above make the simulation slow, so that this thread renders a second much
        // faster than the worker simulates it. If the system suspends this thread meanwhile, the
        // test tries again.
        scene.stepsPerSecond = 20000;
        scene.kinds.push_back({.name = "far", .object = "die"});
        Release far;
        far.kind = scene.kinds.size() - 1;
        far.count = 30;
        far.positionMetres = {.mean = {0, 0, 600}, .reach = {500, 500, 100}};
        scene.releases.push_back(far);
        const auto stage =
            SceneStage::make(SceneAssets::make(scene, ObjectLibrary::shared()).value()).value();
        Player player(Instrument::onStage({.kind = KeyMapKind::scene, .object = {}}, stage->slots(),
                                          stage->slotOfKey(0, 127), stage),
                      rate);
        std::vector<float> sound;
        for (int attempt = 0; attempt < 100 && player.stage().lateEvents() == 0; ++attempt) {
            player.reset();
            play(player, {{0, 72, 100}}, 1, 512);
            player.stage().waitForSimulation();
            sound = play(player, {}, 0.1, 512);
        }
        CHECK(player.stage().lateEvents() > 0);
        CHECK(tailLevel(sound, 0) > 0);
    }
}

TEST_CASE("Keys of a scene without notes restart the scene") {
    const auto instrument = sceneInstrument("Cylinder off a table");
    const double delay = instrument->stage()->delaySeconds();
    CHECK(delay > 0);
    CHECK(instrument->key(60).slot >= 0);
    CHECK_FALSE(instrument->keysHaveObjects());
    Player player(instrument, rate);
    player.stage().setOffline(true);
    const auto sound = play(player, {{0, 60, 64}}, 2, 256);
    CHECK(onsetSeconds(sound) > 0.5 * delay);
    CHECK(onsetSeconds(sound) < delay + 0.3);
    CHECK_FALSE(player.silent());
}

TEST_CASE("A note of a scene counts as sounding before its bodies hit anything") {
    const auto instrument = sceneInstrument("Cylinder off a table");
    Player player(instrument, rate);
    player.stage().setOffline(true);
    CHECK_FALSE(player.sounds(60));
    play(player, {{0, 60, 64}}, 0.25 * instrument->stage()->delaySeconds(), 256);
    CHECK(player.sounds(60));
}

TEST_CASE("A note beyond the maximum replaces the oldest simulation, and All Sound Off ends all") {
    const auto instrument = sceneInstrument("Dice on a xylophone");
    Player player(instrument, rate);
    player.stage().setOffline(true);
    std::vector<Note> notes;
    for (int k = 0; k < 40; ++k)
        notes.push_back({0.02 * k, 65 + k, 100});
    play(player, notes, 1, 128);
    std::vector<float> left(64), right(64);
    const std::vector<MidiEvent> off{{0, {0xb0, 120, 0}}};
    player.process({left, right}, off, {});
    const auto after = play(player, {}, 2, 128);
    CHECK(player.silent());
    CHECK(after.back() == 0);
    // A silenced body rings again when it is struck.
    const auto again = play(player, {{0, 72, 100}}, 0.7, 128);
    CHECK(tailLevel(again, 0.5) > 0.001f);
}

TEST_CASE("After All Sound Off, the next cylinder makes the table ring again") {
    const auto instrument = sceneInstrument("Cylinder off a table");
    Player first(instrument, rate), second(instrument, rate);
    for (auto* player : {&first, &second})
        player->stage().setOffline(true);
    const auto expected = play(first, {{0, 60, 64}}, 0.5, 128);
    std::vector<float> left(64), right(64);
    const std::vector<MidiEvent> off{{0, {0xb0, 120, 0}}};
    second.process({left, right}, off, {});
    CHECK(play(second, {{0, 60, 64}}, 0.5, 128) == expected);
}

TEST_CASE("Rolling before All Sound Off does not ring on during the next note") {
    Player player(sceneInstrument("Cylinder off a table"), rate);
    player.stage().setOffline(true);
    const auto before = play(player, {{0, 60, 100}}, 0.6, 128);
    std::vector<float> left(64), right(64);
    const std::vector<MidiEvent> next{{0, {0xb0, 120, 0}}, {0, {0x90, 60, 1}}};
    player.process({left, right}, next, {});
    // Listen before the next cylinder lands and after the delay to the ears.
    const auto after = play(player, {}, 0.06, 128);
    CHECK(tailLevel(after, 0.025) < 1e-4f * tailLevel(before, 0.5));
}

TEST_CASE("Rolling does not click when it is paused, resumed, stopped or replaced") {
    const auto instrument = sceneInstrument("Cylinder off a table");
    constexpr std::size_t restCells = 100;
    enum class End { none, pause, stop, note };
    const auto rolled = [&](std::size_t cells, End end) {
        // Seven more cylinders are in the air, so that the next note replaces the first one's
        // simulation.
        std::vector<Note> notes{{0, 60, 64}};
        if (end == End::note)
            for (int k = 0; k < 7; ++k)
                notes.push_back(
                    {(static_cast<double>(cells) - 7 + k) * cellSamples / rate, 60, 64});
        Player player(instrument, rate);
        player.stage().setOffline(true);
        const auto seconds = [](std::size_t count) {
            return static_cast<double>(count * cellSamples) / rate;
        };
        auto sound = play(player, notes, seconds(cells), cellSamples);
        sound.resize(sound.size() / 2);
        const auto goOn = [&](const std::vector<Note>& more, std::size_t count) {
            const auto next = play(player, more, seconds(count), cellSamples);
            sound.insert(sound.end(), next.begin(),
                         next.begin() + static_cast<std::ptrdiff_t>(next.size() / 2));
        };
        player.stage().pause(end == End::pause);
        if (end == End::stop)
            player.stage().clear();
        goOn(end == End::note ? std::vector<Note>{{0, 60, 64}} : std::vector<Note>(), restCells);
        player.stage().pause(false);
        goOn({}, 10);
        return sound;
    };
    for (const std::size_t cells : {770u, 807u, 844u}) {
        const std::size_t cut = cells * cellSamples, again = cut + restCells * cellSamples;
        const double kink = kinkFrom(rolled(cells, End::none), cut);
        for (const auto end : {End::pause, End::stop, End::note}) {
            INFO(cells << " cells, end " << static_cast<int>(end));
            const auto sound = rolled(cells, end);
            CHECK(kinkFrom(sound, cut) < 2 * kink);
            if (end == End::pause)
                CHECK(kinkFrom(sound, again) < kink);
        }
    }
}

TEST_CASE("The soft pedal slows the bodies that a note throws") {
    const auto thrown = [](int pedal, int velocity) {
        Player player(sceneInstrument("Dice on a xylophone"), rate);
        player.stage().setOffline(true);
        std::vector<float> left(64), right(64);
        const std::vector<MidiEvent> down{{0, {0xb0, 67, static_cast<std::uint8_t>(pedal)}}};
        player.process({left, right}, down, {});
        return play(player, {{0, 72, velocity}}, 0.7, 128);
    };
    const auto softly = thrown(127, 100);
    CHECK(softly == thrown(0, 50));
    CHECK(softly != thrown(0, 100));
}

TEST_CASE("A stage without a note drop has a slot for each bar") {
    auto scene = *findFactoryScene("Dice on a xylophone");
    scene.noteDrop.reset();
    scene.kinds = {
        {.name = "ball", .object = "", .given = silentBall(0.01, *findMaterial("Steel"))}};
    scene.releases = {Release()}; // of the ball
    const auto assets = SceneAssets::make(scene, ObjectLibrary::shared()).value();
    const auto stage = SceneStage::make(assets).value();
    const auto slots = stage->slotOfKey(0, 127);
    CHECK(slots[65] == 0);
    CHECK(slots[108] == 43);
    for (const int slot : slots)
        CHECK(slot < static_cast<int>(stage->slots().size()));
}

TEST_CASE("Every factory scene is an instrument") {
    for (const auto& scene : factoryScenes()) {
        INFO(scene.name);
        const auto instrument = sceneInstrument(scene.name);
        CHECK(instrument->stage()->delaySeconds() < 2);
        CHECK(instrument->key(72).slot >= 0);
    }
}

TEST_CASE("A scene that takes too long to begin is soon refused with a sentence") {
    const auto refusal = [](const Scene& scene) {
        const auto made =
            SceneStage::make(SceneAssets::make(scene, ObjectLibrary::shared()).value());
        REQUIRE_FALSE(made);
        CHECK(made.error().message.find("'Too much'") != std::string::npos);
        return made.error().message;
    };
    auto scene = parseScene(R"({"format": "idiophone-scene", "version": 1, "name": "Too much",
                                "kinds": [{"name": "die", "object": "die"}],
                                "bodies": [{"kind": "die", "count": 10000}]})",
                            "test")
                     .value();
    CHECK(refusal(scene).find("has 10000 bodies, more than the 500") != std::string::npos);
    scene.releases[0].count = 400;
    CHECK(refusal(scene).find("too many bodies in one place") != std::string::npos);

    // Bodies fall for minutes, because gravity is almost 0.
    scene.releases[0].count = 100;
    scene.releases[0].positionMetres.reach = {500, 500, 500};
    scene.noteDrop = NoteDrop();
    scene.noteDrop->softestMetres = scene.noteDrop->hardestMetres = 100;
    scene.gravityMetresPerSecond2 = 0;
    scene.stepsPerSecond = 20000;
    CHECK(refusal(scene).find("fall for too long") != std::string::npos);
}

TEST_CASE("A scene whose first impact needs much work shows no delay") {
    auto scene = parseScene(R"({"format": "idiophone-scene", "version": 1, "name": "Late",
                                "kinds": [{"name": "floor", "object": "floor", "form": "ground",
                                           "fixed": true},
                                          {"name": "die", "object": "die"}],
                                "bodies": [{"kind": "floor"}, {"kind": "die", "at": [0, 0, 1]},
                                           {"kind": "die", "count": 100, "at": [0, 0, 600],
                                            "at_scatter": [500, 500, 100]}]})",
                            "test")
                     .value();
    const auto delay = [&] {
        const auto assets = SceneAssets::make(scene, ObjectLibrary::shared()).value();
        return SceneStage::make(assets).value()->delaySeconds();
    };
    CHECK(delay() > 0.4);
    scene.stepsPerSecond = 20000;
    CHECK(delay() == 0);
}

TEST_CASE("A scene instrument returns its objects by the names in its scene") {
    const auto stage = sceneInstrument("Dice on a xylophone")->stage();
    CHECK(stage->objectOf(0) == "xylophone-65");
    CHECK(stage->objectOf(44) == "die");
}

TEST_CASE("A missing scene is named in the error") {
    const auto built = buildInstrument({.kind = KeyMapKind::scene, .object = "nowhere.json"},
                                       ObjectLibrary::shared());
    REQUIRE_FALSE(built);
    CHECK(built.error().message.find("nowhere.json") != std::string::npos);
}
