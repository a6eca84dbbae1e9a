// The integrated loudness of ITU-R BS.1770, by libebur128.
#pragma once

#include <ebur128.h>
#include <memory>
#include <optional>
#include <span>

namespace idiophone {

/// Throws std::bad_alloc where memory ends.
class LoudnessMeter {
public:
    LoudnessMeter(int channels, int sampleRateHz);

    /// Appends samples of full scale 1: one of each channel, and so on.
    void add(std::span<const float> interleaved);

    /// Of all so far; nothing where it is fainter than the gate, -70 LUFS.
    std::optional<double> integratedLufs() const;

    /// The loudness of the last 400 ms. Silence has -infinity.
    double momentaryLufs() const;

private:
    struct Free {
        void operator()(ebur128_state* state) const;
    };

    std::unique_ptr<ebur128_state, Free> state;
};

/// The LUFS of the loudest 400 ms, tried every 10 ms. Silence and shorter sounds have -infinity.
double loudestMomentLufs(std::span<const float> interleaved, int channels, int sampleRateHz);

} // namespace idiophone
