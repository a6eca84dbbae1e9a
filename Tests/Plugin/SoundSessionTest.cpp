#include "Plugin/SoundSession.h"

#include "Plugin/RealTimeTrap.h"
#include "Plugin/SessionParts.h"

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;

TEST_CASE("A played sound reaches the engine as a player with its values") {
    SessionParts parts;
    const auto sound = testSound();
    parts.play(sound);
    const auto player = parts.takePlayer();
    REQUIRE(player != nullptr);
    CHECK(&player->instrument() == sound.instrument.get());
    CHECK(parts.messages.soundChanges % 2 == 0);
    CHECK(parts.parameters.values() == sound.parameters);
    CHECK(parts.session.loadedSound() == sound);
    CHECK(parts.session.loadedSound().preset.name == "Test keyboard");
    CHECK(parts.session.number() == 1);
}

TEST_CASE("A sound without an instrument does not play") {
    SessionParts parts;
    const Sound nothing;
    CHECK_FALSE(parts.session.playSound(nothing));
    CHECK(parts.session.number() == 0);
    CHECK(parts.session.instrument() == nullptr);
}

TEST_CASE("Reading the playing preset copies only its texts") {
    SessionParts parts;
    parts.play();
    PlayingPreset playing;
    const auto faults = faultsOf([&] { playing = parts.session.playingPreset(); });
    CHECK(playing.details.name == "Test keyboard"); // short enough to be stored without allocation
    CHECK(faults.allocations == 0);
}

TEST_CASE("A session hands over no player until it is prepared") {
    SessionParts parts;
    REQUIRE(parts.session.playSound(testSound()));
    CHECK(parts.takePlayer() == nullptr);
    std::unique_ptr<Player> installed;
    parts.session.prepare(44100,
                          [&](std::unique_ptr<Player> player) { installed = std::move(player); });
    REQUIRE(installed != nullptr);
    CHECK(installed->synthesiser().sampleRateHz() == 44100);
    CHECK(parts.session.rateHz() == 44100);
}

TEST_CASE(
    "A sound that differs only in parameters keeps its player, unless its level differs too much") {
    SessionParts parts;
    auto sound = testSound();
    parts.play(sound);
    parts.takePlayer();
    sound.parameters.set(density, 1234);
    CHECK(parts.session.playSound(sound));
    CHECK(parts.takePlayer() == nullptr);
    CHECK(parts.parameters[density].exactValue() == 1234);
    sound.parameters.set(level, sound.parameters[level] - 20);
    CHECK(parts.session.playSound(sound));
    CHECK(parts.takePlayer() != nullptr);
}

TEST_CASE("Changed parameters are set only while their sound plays") {
    SessionParts parts;
    parts.play();
    auto now = parts.session.loadedSound();
    auto wanted = now.parameters;
    wanted.set(density, 1234);
    parts.session.changeParameters(now, wanted);
    CHECK(parts.parameters[density].exactValue() == 1234);
    CHECK(parts.session.playingPreset().isChanged);
    now.instrument = testSound("other").instrument;
    wanted.set(density, 4321);
    parts.session.changeParameters(now, wanted);
    CHECK(parts.parameters[density].exactValue() == 1234);
}

TEST_CASE("Key maps of one object keep the sound's origin; another preset name does not") {
    SessionParts parts;
    auto sound = testSound();
    parts.play(sound);
    const int origin = parts.session.origin();
    sound.preset.seed = 7;
    REQUIRE(parts.session.playSound(sound));
    CHECK(parts.session.number() == 2);
    CHECK(parts.session.origin() == origin);
    sound.preset.seed = 8;
    sound.preset.name = "Another";
    REQUIRE(parts.session.playSound(sound));
    CHECK(parts.session.origin() == parts.session.number());
}

TEST_CASE("The status shows the sound, and after an error or invalid output a sentence about it") {
    SessionParts parts;
    auto sound = testSound();
    sound.preset.description = "Thirteen bars.";
    parts.play(sound);
    parts.report.peak = 0.5f;
    auto status = parts.session.takeStatus();
    CHECK(status.sentence == "Thirteen bars.");
    CHECK(status.peak == 0.5f);
    CHECK(parts.session.takeStatus().peak == 0);
    parts.session.reportError("It fails.");
    status = parts.session.takeStatus();
    CHECK(status.isError);
    CHECK(status.sentence == "It fails.");
    ++parts.report.notFinite;
    parts.session.poll();
    CHECK(parts.session.takeStatus().sentence.starts_with("The sound was not finite"));
}
