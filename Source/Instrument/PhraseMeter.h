// Computes the loudness of a phrase from the energies of its modes: ITU-R BS.1770-4 for decaying
// sinusoids in place of samples. It does not depend on objects or mallets.
#pragma once

#include <array>
#include <cstddef>

namespace idiophone {

/// Returns the power gain of K-weighting (BS.1770-4, annex 1) at a frequency ≥ 0.
double kWeightingPower(double hz) noexcept;

/// Meters eight notes, two a second, and half a second of silence after the last note-off. Does not
/// allocate.
class PhraseMeter {
public:
    static constexpr std::size_t notes = 8;
    static constexpr double noteSeconds = 0.5;

    /// A value for each note of the phrase.
    using NoteFigures = std::array<double, notes>;

    /// `struck` notes get their energy at the start; `sustained` ones get the same energy
    /// throughout.
    enum class Note { struck, sustained };

    /// Adds a lightly damped mode that the notes excite to those K-weighted powers: the mean square
    /// at its start, half the squared amplitude of a decaying sinusoid. Its amplitude falls as
    /// e^(−αt) with the `decay` α > 0 [1/s]. After the end of each note `release` ≥ 0 [1/s] adds to
    /// α. As complex numbers, power and decay are those of two modes' interference: the power is
    /// the real part, which turns with the imaginary part of 2α. Number is double or
    /// std::complex<double>.
    template <class Number>
    void addMode(Note note,
                 const std::array<Number, notes>& powers,
                 Number decay,
                 double release) noexcept;

    /// Adds K-weighted energies (power times seconds) at the start of each note.
    void addTransients(const NoteFigures& energies) noexcept;

    /// Adds K-weighted powers that last exactly as long as the notes.
    void addSteady(const NoteFigures& powers) noexcept;

    /// Returns the integrated loudness of one channel in LUFS, with the relative gate and without
    /// the absolute one; −infinity if nothing sounds.
    double integratedLufs() const noexcept;

private:
    // The standard's blocks of four hops, one starting every hop: 0.4 s with 75 % overlap.
    static constexpr double hopSeconds = 0.1;
    static constexpr std::size_t blockHops = 4;
    static constexpr auto noteHops = static_cast<std::size_t>(noteSeconds / hopSeconds + 0.5);
    static constexpr std::size_t phraseHops = (notes + 1) * noteHops;

    std::array<double, phraseHops> hopEnergies{};
};

} // namespace idiophone
