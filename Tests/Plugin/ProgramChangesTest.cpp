#include "Plugin/ProgramChanges.h"

#include "Plugin/SessionParts.h"

#include <array>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr MidiEvent change{.sampleOffset = 0, .bytes = {0xc0, 1, 0}};
constexpr MidiEvent key{.sampleOffset = 3, .bytes = {0x90, 60, 100}};

std::unique_ptr<Player> answerTo(ProgramChanges::Request request) {
    auto player = std::make_unique<Player>(testSound().instrument, 48000.0);
    player->setLabel(request);
    return player;
}

} // namespace

TEST_CASE("A program change is pending until its player is handed over, and then its keys strike") {
    ProgramChanges programs(2);
    CHECK(programs.pending() == ProgramChanges::none);
    programs.follow(std::array{change, key});
    const auto request = programs.pending();
    REQUIRE(request != ProgramChanges::none);
    CHECK(ProgramChanges::programOf(request) == 1);
    CHECK(programs.takeKeys(nullptr).empty());
    programs.answer(request);
    programs.end(request, true);
    CHECK(programs.pending() == ProgramChanges::none);
    const auto other = answerTo(request - 1), answer = answerTo(programs.label());
    CHECK(programs.takeKeys(other.get()).empty());
    const auto keys = programs.takeKeys(answer.get());
    REQUIRE(keys.size() == 1);
    CHECK(keys[0].bytes[1] == 60);
}

TEST_CASE("A refused or cancelled request forgets its keys") {
    for (const bool isCancelled : {false, true}) {
        ProgramChanges programs(2);
        programs.follow(std::array{change, key});
        const auto request = programs.pending();
        if (isCancelled)
            programs.cancel();
        else
            programs.end(request, false);
        CHECK(programs.pending() == ProgramChanges::none);
        CHECK(programs.takeKeys(nullptr).empty());
        const auto late = answerTo(request);
        CHECK(programs.takeKeys(late.get()).empty());
    }
}

TEST_CASE("A newer request stays pending when the older one ends") {
    ProgramChanges programs(2);
    programs.follow(std::array{change});
    const auto older = programs.pending();
    programs.follow(std::array{change});
    const auto newer = programs.pending();
    CHECK(newer != older);
    programs.end(older, true);
    CHECK(programs.pending() == newer);
}

TEST_CASE("The session sees the values at the last program change of a block") {
    BareHost host;
    HostParameters parameters(host);
    ProgramChanges programs(2);
    juce::MidiBuffer midi;
    midi.addEvent(juce::MidiMessage::controllerEvent(1, 21, 5), 0);
    CHECK(programs.behindLast(midi) == midi.begin());
    midi.addEvent(juce::MidiMessage::programChange(1, 1), 1);
    CHECK(programs.behindLast(midi) == midi.end());
    parameters[ParameterId::density].setExactValue(1234);
    programs.keepMoment(parameters, 6);
    parameters[ParameterId::density].setExactValue(4321);
    programs.follow(std::array{change});
    CHECK(programs.momentOf(ProgramChanges::none) == nullptr);
    const auto* moment = programs.momentOf(programs.pending());
    REQUIRE(moment != nullptr);
    CHECK(moment->soundChanges == 6);
    CHECK(moment->values[ParameterId::density] == 1234);
    CHECK(parameters.withMoved(moment->moves, {})[ParameterId::density] == 4321);
}
