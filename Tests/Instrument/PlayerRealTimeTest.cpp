#include "Instrument/Player.h"
#include "Support/AllocationCounter.h"
#include "Support/Level.h"
#include "Support/RenderNotes.h"
#include "TestInstruments.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;

namespace {

struct Playing {
    long allocations = 0;
    float loudest = 0;
};

/// Plays keys 40 to 100. Every fourth block of 10 ms repeats the crowd of events. `setBefore(block,
/// parameters)` changes the parameters before each block.
template <class Setter>
Playing playCrowd(KeyMapKind kind,
                  const std::vector<MidiEvent>& crowd,
                  int blocks,
                  ParameterValues parameters,
                  const Setter& setBefore) {
    Player player(keysOn(syntheticObject({200, 540, 1070, 1800, 2500}), kind, 40, 100), 48000);
    StereoSound output(480);
    Playing playing;
    const AllocationCounter counter;
    for (int block = 0; block < blocks; ++block) {
        setBefore(block, parameters);
        player.process(output,
                       block % 4 == 0 ? std::span<const MidiEvent>(crowd)
                                      : std::span<const MidiEvent>(),
                       parameters);
        playing.loudest = std::max({playing.loudest, peak(output.left), peak(output.right)});
    }
    playing.allocations = counter.allocations();
    return playing;
}

} // namespace

TEST_CASE("Held keys that scrape, roll and bow never allocate, however many are held") {
    std::vector<MidiEvent> crowd;
    for (int i = 0; i < 300; ++i) {
        crowd.push_back(midi(i, i % 4 == 3 ? 0x80 : 0x90, 40 + i * 7 % 61, 1 + i % 127));
        crowd.push_back(midi(i, 0xa0, 40 + i % 61, i % 128));
        crowd.push_back(midi(i, 0xd0, i % 128, 0));
        crowd.push_back(midi(i, 0xb0, i % 2 == 0 ? 1 : 74, i % 128));
    }
    const auto playing =
        playCrowd(KeyMapKind::zones, crowd, 60, {}, [](int block, ParameterValues& parameters) {
            parameters.set(contact, block % 20 == 19 ? strikeContact : 1 + block / 10 % 3);
            parameters.set(rollCoupling, block % 3 * 50);
        });
    CHECK(playing.allocations == 0);
    CHECK(playing.loudest > 1e-5f);
    CHECK(std::isfinite(playing.loudest));
}

TEST_CASE("Chattering strikes with modal pulses never allocate, however many come at once") {
    ParameterValues parameters;
    parameters.set(chatter, 100);
    std::vector<MidiEvent> crowd;
    for (int i = 0; i < 300; ++i)
        crowd.push_back(midi(i % 100 == 0 ? i : i - i % 100, 0x90, 40 + i % 61, 1 + i % 127));
    const auto playing = playCrowd(KeyMapKind::scaled, crowd, 80, parameters,
                                   [](int block, ParameterValues& changed) {
                                       changed.set(mallet, block % 8);
                                       changed.set(modalPulse, block % 3 == 0 ? 1 : 0);
                                   });
    CHECK(playing.allocations == 0);
    CHECK(playing.loudest > 0.001f);
    CHECK(std::isfinite(playing.loudest));
}
