// A feedback delay network: the dense tail of a room, for two channels.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace idiophone {

/// Sixteen delay lines that an orthogonal matrix feeds back (Jot & Chaigne 1991, AES preprint
/// 3030), behind four allpass diffusers a channel (Schroeder 1962, JAES 10, 219). `prepare` is for
/// while nothing processes; the rest is for the audio thread and neither allocates, locks nor
/// throws. The samples do not depend on block sizes.
class DelayNetwork {
public:
    static constexpr std::size_t lineCount = 16;
    static constexpr double shortestSeconds = 0.02;  ///< from the input to the first output
    static constexpr double longestSeconds = 0.0617; ///< of all lines

    /// At a rate of at least 1000 Hz. A new decay time is reached over `glideSeconds`.
    void prepare(double sampleRateHz, double glideSeconds);

    /// Silences the network. A new decay time then holds at once.
    void clear() noexcept;

    /// In this time low tones fade by 60 dB. High ones fade sooner: at 8 kHz in 1/(1/(0.6 T) +
    /// 1/1.7 s), the walls of a furnished room and air at 20 degrees and 50 % humidity (ISO
    /// 9613-1).
    void setDecay(double seconds) noexcept;

    /// Replaces both channels with what the network answers, noise of 1 with noise of about 1
    /// where the decay time is 1 s.
    void process(std::span<float> left, std::span<float> right) noexcept;

private:
    static constexpr std::size_t mostAtOnce = 64, diffuserCount = 4;
    using Block = std::array<float, mostAtOnce>;

    struct Delay {
        std::vector<float> samples;
        std::size_t position = 0;
    };
    /// A low-pass of one pole and a gain, by which the line's sound decays.
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
    std::array<Block, lineCount> blocks{}; ///< what comes out of each line
};

} // namespace idiophone
