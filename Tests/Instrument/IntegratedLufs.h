// What libebur128 measures of a sound.
#pragma once

#include <ebur128.h>
#include <span>

namespace idiophone::test {

/// The gated loudness of EBU R 128 of the whole sound.
inline double
integratedLufs(std::span<const float> interleaved, unsigned channels, double sampleRateHz) {
    auto* meter = ebur128_init(channels, static_cast<unsigned long>(sampleRateHz), EBUR128_MODE_I);
    ebur128_add_frames_float(meter, interleaved.data(), interleaved.size() / channels);
    double result = 0;
    ebur128_loudness_global(meter, &result);
    ebur128_destroy(&meter);
    return result;
}

} // namespace idiophone::test
