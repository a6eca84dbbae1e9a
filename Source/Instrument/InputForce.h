// Sound that comes in presses on an object, as a force at the place where a key strikes.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/StripGlide.h"
#include "Parameters/ParameterTable.h"
#include "Synth/Synthesiser.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace idiophone {

/// Constructed off the audio thread; the rest is for the audio thread and neither allocates, locks
/// nor throws. The instrument must outlive it. It acts on one key's object at a time. Each sample
/// is an impulse, as of a strike, so nothing is late: the samples need not be known in advance.
///
/// At a drive of 0 dB, full scale presses with a key's newtons (InputStrengths.h).
class InputForce {
public:
    InputForce(const Instrument& instrument,
               double sampleRateHz,
               const std::array<double, 128>& newtonsOfFullScale, // [notes]
               std::size_t contactOfForce);

    /// Chooses the key from the next cell on; at first, the key nearest to middle C. Does nothing
    /// for a key without an object.
    void choose(int note) noexcept;
    /// Chooses the lowest key that plays this slot.
    void chooseSlot(std::size_t slot) noexcept;

    /// Marks that there is an input; without one, cells cost nothing.
    void connect() noexcept { isConnected = true; }
    /// Moves on to the cell that begins now. After a choice the force fades out over a cell, and
    /// the other key's begins.
    void beginCell(const ParameterValues& values) noexcept;
    /// Takes the input at the cell's next samples: mono, full scale 1; empty is silence. Returns
    /// the sample of the cell from which on the force acts, if it is among these. Call `press`
    /// then, after the strikes before that sample.
    std::optional<std::size_t>
    take(std::span<const float> input, std::size_t position, std::size_t count) noexcept;
    void press(Synthesiser& synthesiser) noexcept;
    /// Adds the sound of the samples taken last to their slot's cell.
    void sound(std::size_t position,
               std::size_t count,
               const Synthesiser& synthesiser,
               std::span<const CellOutput> cellsOfSlots) const noexcept;
    /// Lets the whole cell act on the object; call it after the cell's last samples.
    void endCell(Synthesiser& synthesiser) noexcept;

    /// Returns the slot on which it pressed in the last whole cell.
    std::optional<std::size_t> slotPressed() const noexcept { return pressed; }
    bool silent() const noexcept { return !presses && lowCut.isQuiet(); }
    void reset() noexcept; ///< keeps the key

private:
    /// A high-pass of second order (Butterworth; A. Simper's linear trapezoidal state variable
    /// filter, 2013).
    class LowCut {
    public:
        void tune(double hertz, double sampleRateHz) noexcept; ///< 0: lets all pass
        double pass(double sample) noexcept;
        bool isQuiet() const noexcept { return first == 0 && second == 0; }
        bool isFaint() const noexcept;
        void reset() noexcept { first = second = 0; }

    private:
        double g = 0;
        double first = 0, second = 0; ///< states
    };

    void changeKey(const ParameterValues& values) noexcept;
    ForceCell force() const noexcept {
        return {
            .contact = contact, .start = start, .end = end, .newtons = newtons, .isImpulses = true};
    }

    const Instrument& instrument;
    double rateHz;
    std::array<double, 128> newtonsOfKeys;
    std::size_t contact;
    int note = -1;    ///< of the chosen key; −1: none plays an object
    int noteNow = -1; ///< of the key in this cell
    bool isConnected = false;
    LowCut lowCut;
    double gainBefore = 0, gain = 0; ///< in newtons, at the cell's start and end
    StripGlide place;
    ForcePlace start, end;
    alignas(64) std::array<float, cellSamples> newtons{};
    bool presses = false; ///< in this cell
    HeardForce heard;     ///< while it presses
    std::optional<std::size_t> pressed;
};

} // namespace idiophone
