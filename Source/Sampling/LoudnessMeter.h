// The integrated loudness of ITU-R BS.1770, by libebur128.
#pragma once

#include <ebur128.h>
#include <memory>
#include <optional>
#include <span>

namespace idiophone {

inline constexpr int measuredRateHz = 48000; ///< sample rate of the programs that measure loudness

/// Throws std::bad_alloc if memory runs out.
class LoudnessMeter {
public:
    LoudnessMeter(int channels, int sampleRateHz);

    /// Appends interleaved samples of full scale 1.
    void add(std::span<const float> interleaved);

    /// Returns the loudness so far, or nothing below the gate of -70 LUFS.
    std::optional<double> integratedLufs() const;

    /// Returns the loudness of the last 400 ms, -infinity for silence.
    double momentaryLufs() const;

private:
    struct Free {
        void operator()(ebur128_state* state) const;
    };

    std::unique_ptr<ebur128_state, Free> state;
};

/// Returns the LUFS of the loudest 400 ms, in steps of 10 ms. Silence and shorter sounds have
/// -infinity.
double loudestMomentLufs(std::span<const float> interleaved, int channels, int sampleRateHz);

} // namespace idiophone
