// The check that a player sounds alike whatever the sizes of the blocks it is rendered in.
#pragma once

#include "Support/RenderNotes.h"

#include <catch2/catch_test_macros.hpp>
#include <initializer_list>
#include <memory>
#include <vector>

namespace idiophone::test {

/// CHECKs that in blocks of each of these sizes a new player, and again the same one after a reset,
/// sounds to the last bit as in blocks of 512 samples, and returns that sound.
inline StereoSound checkSameInBlocksOf(std::initializer_list<std::size_t> blockSizes,
                                       const std::shared_ptr<const Instrument>& instrument,
                                       double sampleRateHz,
                                       const std::vector<MidiEvent>& events,
                                       std::size_t samples,
                                       const ParameterValues& parameters) {
    Player reference(instrument, sampleRateHz);
    const auto expected = renderStereo(reference, events, samples, 512, parameters);
    for (const std::size_t blockSize : blockSizes) {
        INFO("blocks of " << blockSize);
        Player player(instrument, sampleRateHz);
        CHECK(renderStereo(player, events, samples, blockSize, parameters) == expected);
        player.reset();
        CHECK(player.silent());
        CHECK(renderStereo(player, events, samples, blockSize, parameters) == expected);
    }
    return expected;
}

} // namespace idiophone::test
