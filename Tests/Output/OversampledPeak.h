// Measures the true peak by two meters: the filter of ITU-R BS.1770-4 and a steeper one of eight
// phases.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace idiophone::test {

/// Returns the maximum magnitude of the samples convolved with each phase of a filter, one phase a
/// row.
template <typename Phases>
double highestFiltered(const std::vector<float>& samples, const Phases& phases) {
    double highest = 0;
    for (const auto& phase : phases)
        for (std::size_t end = 0; end < samples.size() + phase.size(); ++end) {
            double sum = 0;
            for (std::size_t tap = 0; tap < phase.size(); ++tap)
                if (end >= tap && end - tap < samples.size())
                    sum += phase[tap] * static_cast<double>(samples[end - tap]);
            highest = std::max(highest, std::abs(sum));
        }
    return highest;
}

/// ITU-R BS.1770-4, Annex 2, table of 48 coefficients.
inline constexpr std::array<std::array<double, 12>, 4> bs1770Phases{
    {{0.0017089843750, 0.0109863281250, -0.0196533203125, 0.0332031250000, -0.0594482421875,
      0.1373291015625, 0.9721679687500, -0.1022949218750, 0.0476074218750, -0.0266113281250,
      0.0148925781250, -0.0083007812500},
     {-0.0291748046875, 0.0292968750000, -0.0517578125000, 0.0891113281250, -0.1665039062500,
      0.4650878906250, 0.7797851562500, -0.2003173828125, 0.1015625000000, -0.0582275390625,
      0.0330810546875, -0.0189208984375},
     {-0.0189208984375, 0.0330810546875, -0.0582275390625, 0.1015625000000, -0.2003173828125,
      0.7797851562500, 0.4650878906250, -0.1665039062500, 0.0891113281250, -0.0517578125000,
      0.0292968750000, -0.0291748046875},
     {-0.0083007812500, 0.0148925781250, -0.0266113281250, 0.0476074218750, -0.1022949218750,
      0.9721679687500, 0.1373291015625, -0.0594482421875, 0.0332031250000, -0.0196533203125,
      0.0109863281250, 0.0017089843750}}};

/// Eight phases of a Hann-windowed sinc of 32 taps.
inline const std::vector<std::vector<double>>& steepPhases() {
    static const auto made = [] {
        std::vector<std::vector<double>> phases(8, std::vector<double>(32));
        for (std::size_t phase = 0; phase < 8; ++phase)
            for (std::size_t tap = 0; tap < 32; ++tap) {
                const double time = static_cast<double>(tap) - 16 + static_cast<double>(phase) / 8;
                const double angle = std::numbers::pi * time;
                phases[phase][tap] =
                    (time == 0 ? 1 : std::sin(angle) / angle) * (0.5 + 0.5 * std::cos(angle / 16));
            }
        return phases;
    }();
    return made;
}

/// Returns the higher result of both meters, in dB of full scale.
inline double decibelsTruePeak(const std::vector<float>& samples) {
    return 20 * std::log10(std::max(highestFiltered(samples, bs1770Phases),
                                    highestFiltered(samples, steepPhases())));
}

} // namespace idiophone::test
