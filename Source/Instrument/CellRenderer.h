// Renders the grid: cells of ringing and held sound, with dampers, tubes and gain, copied out in
// parts of any length.
#pragma once

#include "Instrument/CellStrategy.h"
#include "Instrument/Dampers.h"
#include "Instrument/HandScrape.h"
#include "Instrument/HeldContacts.h"
#include "Instrument/InputForce.h"
#include "Instrument/KeyState.h"
#include "Instrument/Motor.h"
#include "Instrument/SilencedModes.h"
#include "Instrument/SlotOutputs.h"
#include "Instrument/StereoSpan.h"

#include <memory>
#include <optional>

namespace idiophone {

/// Constructed off the audio thread; the rest is for the audio thread and neither allocates, locks
/// nor throws. Instrument, contacts, hand and input must outlive it.
class CellRenderer {
public:
    CellRenderer(const Instrument& instrument,
                 double sampleRateHz,
                 std::unique_ptr<CellStrategy> strategy,
                 HeldContacts& contacts,
                 HandScrape& hand,
                 InputForce& input);

    /// Applies settings and dampers to all slots at once; off the audio thread, before the first
    /// cell.
    void prepare(const ParameterValues& values, const KeyState& keys);

    /// Moves the motor by a cell; call before `beginCell`. If `songTurns` is given, the motor
    /// follows these turns, at once if `isAtOnce`.
    void turnMotor(const ParameterValues& values,
                   double beatsPerMinute,
                   std::optional<double> songTurns,
                   bool isAtOnce);
    /// Says where sound is heard from the next cell on. At first only on the main output.
    void connect(OutputSet outputs) { connected = outputs; }
    void beginCell(const ParameterValues& values, const KeyState& keys, StrikeScheduler& strikes);
    /// Moves the gain towards its goal over the newest cell. The first cell starts at the goal.
    void moveGain(float goal);

    bool cellIsOver() const { return position == cellSamples; }
    bool isWithinCell() const { return position > 0 && !cellIsOver(); }
    int samplesLeft() const { return cellSamples - position; }
    /// Plays the strikes and the input of the cell's next part and copies this part to samples
    /// `from` to `until` of the connected outputs, of which there are at most `maximumOutputs`.
    /// `heard` is the input of the whole block, or empty.
    void copyOut(std::span<const StereoSpan> outputs,
                 std::size_t from,
                 std::size_t until,
                 std::span<const float> heard,
                 StrikeScheduler& strikes);

    /// Returns the moment of a strike at the next sample.
    StrikeMoment moment(const ParameterValues& values, double softness);
    /// Starts the bodies of a note at the next sample.
    void startNote(StagePlayer& stage, int note, int velocity) const {
        stage.startNote(note, velocity, index, position);
    }

    void updateDampers(const ParameterValues& values, const KeyState& keys);
    Dampers& dampers() { return slotDampers; }
    void liftHands();

    void silence() { silenced = true; } ///< damps all sound until `endSilence`
    bool isSilenced() const { return silenced; }
    /// Call before the first strike or contact after `silence`. The strike lifts the damper. Fades
    /// the old sound out over one cell, so that it does not return.
    void endSilence(const ParameterValues& values, const KeyState& keys);

    /// Acts at the next `beginCell`; `reset` keeps it.
    void setSilencedModes(const SilencedModes& modes);
    /// Returns sound and grid to the start. Hands stay on their surfaces.
    void reset();
    bool silent() const; ///< also contacts and hand
    Synthesiser& synthesiser() { return synth; }
    const Synthesiser& synthesiser() const { return synth; }

private:
    BegunCell begunCell() { return {synth, cell.slots, index}; }
    void sound(const ParameterValues& values, StereoCell& into);
    void soundInput(std::span<const float> heard, std::size_t count, StrikeScheduler& strikes);
    void addRemains();
    void followOutputs(const ParameterValues& values);

    const Instrument& instrument;
    Synthesiser synth;
    std::unique_ptr<CellStrategy> strategy;
    HeldContacts& held;
    HandScrape& hand;
    InputForce& input;
    Motor motor;
    StereoCell cell;
    StereoCell remains; ///< old sound after All Sound Off, for the next cell
    bool hasRemains = false;
    bool silenced = false;
    int position = cellSamples;           ///< next sample to copy out
    std::int64_t index = -1;              ///< of the newest cell
    float gainAtStart = 1, gainAtEnd = 1; ///< of the newest cell; linear in between
    OutputSet connected{1};
    SlotOutputs slotOutputs;
    float openAtStart = 1, openAtEnd = 1; ///< another gain, which shuts while outputs change
    Dampers slotDampers;
};

} // namespace idiophone
