// A feedback delay network: the dense reverb tail of a room, for two channels.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace idiophone {

/// Sixteen delay lines with feedback through an orthogonal matrix (Jot & Chaigne 1991, AES preprint
/// 3030). Each channel first passes four allpass diffusers (Schroeder 1962, JAES 10, 219). Call
/// `prepare` while nothing processes. The other functions are for the audio thread and do not
/// allocate, lock or throw. The samples do not depend on block sizes.
class DelayNetwork {
public:
    static constexpr std::size_t lineCount = 16;
    static constexpr double shortestSeconds = 0.02;  ///< from the input to the first output
    static constexpr double longestSeconds = 0.0617; ///< longest line

    /// Expects a rate of at least 1000 Hz. Changes of the decay time glide over `glideSeconds`.
    void prepare(double sampleRateHz, double glideSeconds);

    /// Silences the network. The next decay time applies at once.
    void clear() noexcept;

    /// Sets the time T in which low tones fade by 60 dB. High tones fade sooner: 8 kHz fades in
    /// 1/(1/(0.6 T) + 1/1.7 s). This models the walls of a furnished room and air at 20 °C and 50 %
    /// humidity (ISO 9613-1).
    void setDecay(double seconds) noexcept;

    /// Replaces both channels by the network's response. At a decay time of 1 s, noise of level 1
    /// gives noise of about 1.
    void process(std::span<float> left, std::span<float> right) noexcept;

private:
    static constexpr std::size_t maximumPiece = 64, diffuserCount = 4;
    using Block = std::array<float, maximumPiece>;

    struct Delay {
        std::vector<float> samples;
        std::size_t position = 0;
    };
    /// The decay of a line: a one-pole low-pass and a gain.
    struct Absorber {
        float gain = 0, pole = 0, state = 0;
        float gainTarget = 0, poleTarget = 0, gainStep = 0, poleStep = 0;
    };

    void processPiece(std::span<float> left, std::span<float> right) noexcept;
    void finishGlide() noexcept;
    static void diffuse(std::array<Delay, diffuserCount>& diffusers,
                        std::span<float> samples) noexcept;
    void readLine(std::size_t line, std::size_t sampleCount) noexcept;
    void writeLine(std::size_t line, std::span<const float> input) noexcept;

    double rateHz = 48000;
    std::size_t glideSamples = 0, glideLeft = 0;
    double decaySeconds = 0;
    bool isClear = true;
    std::array<std::array<Delay, diffuserCount>, 2> diffusers;
    std::array<Delay, lineCount> lines;
    std::array<Absorber, lineCount> absorbers;
    std::array<Block, lineCount> blocks{}; ///< outputs of the lines
};

} // namespace idiophone
