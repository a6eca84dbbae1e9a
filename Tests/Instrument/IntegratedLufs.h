// Loudness as libebur128 measures it.
#pragma once

#include <algorithm>
#include <ebur128.h>
#include <span>

namespace idiophone::test {

/// Returns the gated loudness of the whole sound (EBU R 128).
inline double
integratedLufs(std::span<const float> interleaved, unsigned channels, double sampleRateHz) {
    auto* meter = ebur128_init(channels, static_cast<unsigned long>(sampleRateHz), EBUR128_MODE_I);
    ebur128_add_frames_float(meter, interleaved.data(), interleaved.size() / channels);
    double result = 0;
    ebur128_loudness_global(meter, &result);
    ebur128_destroy(&meter);
    return result;
}

/// Returns the LUFS of the loudest 400 ms, searched in steps of 10 ms.
inline double
loudestMomentLufs(std::span<const float> interleaved, unsigned channels, double sampleRateHz) {
    auto* meter = ebur128_init(channels, static_cast<unsigned long>(sampleRateHz), EBUR128_MODE_M);
    const auto hop = channels * static_cast<std::size_t>(sampleRateHz / 100);
    double loudest = -200, moment = 0;
    for (std::size_t at = 0; at + hop <= interleaved.size(); at += hop) {
        ebur128_add_frames_float(meter, interleaved.data() + at, hop / channels);
        if (at >= 39 * hop && ebur128_loudness_momentary(meter, &moment) == EBUR128_SUCCESS)
            loudest = std::max(loudest, moment);
    }
    ebur128_destroy(&meter);
    return loudest;
}

} // namespace idiophone::test
