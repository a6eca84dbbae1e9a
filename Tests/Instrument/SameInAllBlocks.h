// Checks that a player's sound does not depend on the block size.
#pragma once

#include "Support/RenderNotes.h"

#include <catch2/catch_test_macros.hpp>
#include <initializer_list>
#include <memory>
#include <vector>

namespace idiophone::test {

/// CHECKs that for each block size a new player, and the same one after a reset, renders the same
/// bits as with blocks of 512 samples. Returns that sound.
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
