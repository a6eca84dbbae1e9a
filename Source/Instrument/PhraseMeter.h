// The loudness of a phrase from the energies of its modes: a meter after ITU-R BS.1770-4 that hears
// decaying sinusoids instead of samples. Knows nothing of objects or mallets.
#pragma once

#include <array>
#include <cstddef>

namespace idiophone {

/// The power gain of K-weighting (BS.1770-4, annex 1) at a frequency ≥ 0.
double kWeightingPower(double hz) noexcept;

/// Eight notes, two a second, and half a second of silence after the last key is up. Does not
/// allocate.
class PhraseMeter {
public:
    static constexpr std::size_t notes = 8;
    static constexpr double noteSeconds = 0.5;

    /// One figure for each note.
    using NoteFigures = std::array<double, notes>;

    /// Struck at its start, or kept going with the same energy all the while.
    enum class Note { struck, sustained };

    /// Adds a lightly damped mode that the notes excite to those K-weighted powers (the mean square
    /// at its start, of a decaying sinusoid half its squared amplitude). Its amplitude falls as
    /// e^(−αt) with the `decay` α > 0 [1/s], and from the end of each note on with `release` ≥ 0
    /// [1/s] more.
    void addMode(Note note, const NoteFigures& powers, double decay, double release) noexcept;

    /// Adds K-weighted energies, power times seconds, at the start of each note.
    void addTransients(const NoteFigures& energies) noexcept;

    /// Adds what lasts as long as the notes and no longer, of those K-weighted powers.
    void addSteady(const NoteFigures& powers) noexcept;

    /// The integrated loudness of one channel in LUFS, with the relative gate and without the
    /// absolute one; −infinity where nothing sounds.
    double integratedLufs() const noexcept;

private:
    // Blocks of four hops every hop are the standard's: 0.4 s with 75 % of overlap.
    static constexpr double hopSeconds = 0.1;
    static constexpr std::size_t blockHops = 4;
    static constexpr auto noteHops = static_cast<std::size_t>(noteSeconds / hopSeconds + 0.5);
    static constexpr std::size_t phraseHops = (notes + 1) * noteHops;

    std::array<double, phraseHops> hopEnergies{};
};

} // namespace idiophone
