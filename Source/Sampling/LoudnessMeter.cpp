#include "Sampling/LoudnessMeter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

namespace idiophone {

void LoudnessMeter::Free::operator()(ebur128_state* freed) const {
    ebur128_destroy(&freed);
}

LoudnessMeter::LoudnessMeter(int channels, int sampleRateHz)
    : state(ebur128_init(static_cast<unsigned>(channels),
                         static_cast<unsigned long>(sampleRateHz),
                         EBUR128_MODE_I)) {
    if (state == nullptr)
        throw std::bad_alloc();
}

void LoudnessMeter::add(std::span<const float> interleaved) {
    if (ebur128_add_frames_float(state.get(), interleaved.data(),
                                 interleaved.size() / state->channels) != EBUR128_SUCCESS)
        throw std::bad_alloc();
}

std::optional<double> LoudnessMeter::integratedLufs() const {
    double lufs = 0;
    if (ebur128_loudness_global(state.get(), &lufs) != EBUR128_SUCCESS || !std::isfinite(lufs))
        return std::nullopt;
    return lufs;
}

double LoudnessMeter::momentaryLufs() const {
    double lufs = 0;
    return ebur128_loudness_momentary(state.get(), &lufs) == EBUR128_SUCCESS
               ? lufs
               : -std::numeric_limits<double>::infinity();
}

double loudestMomentLufs(std::span<const float> interleaved, int channels, int sampleRateHz) {
    const auto hop = static_cast<std::size_t>(channels * (sampleRateHz / 100));
    LoudnessMeter meter(channels, sampleRateHz);
    double loudest = -std::numeric_limits<double>::infinity();
    for (std::size_t at = 0; at + hop <= interleaved.size(); at += hop) {
        meter.add(interleaved.subspan(at, hop));
        if (at >= 39 * hop)
            loudest = std::max(loudest, meter.momentaryLufs());
    }
    return loudest;
}

} // namespace idiophone
