// Moves parameters by LFOs, envelopes, controllers and the notes themselves: once a cell for all
// notes together, and for each strike and slot by its own note.
#pragma once

#include "Instrument/KeyState.h"
#include "Instrument/Lfo.h"
#include "Instrument/NoteEnvelope.h"
#include "Instrument/NoteShifts.h"
#include "Instrument/ParameterGlide.h"
#include "Parameters/ModulationTable.h"

#include <array>
#include <cstdint>
#include <optional>

namespace idiophone {

/// For the audio thread; neither allocates, locks nor throws. LFOs and envelopes move by cells
/// only, so that a render repeats bit for bit. Without routes all values are those of the glide.
class Modulation {
public:
    /// Number of the note that stands for strikes by hand. It has the velocity of the last one.
    static constexpr int hand = 128;

    /// Glide and keys must outlive it. The seed decides the random sources.
    Modulation(const ParameterGlide& glide,
               const KeyState& keys,
               double secondsPerCell,
               std::uint64_t seed);

    /// Moves single notes too; the shifts must outlive its use. Ringing notes glide to another
    /// pitch as the parameter does.
    void follow(const NoteShifts& shifts) noexcept { hostShifts = &shifts; }

    /// Starts a note, 0 to 127 or `hand`, with a velocity of 1 to 127.
    void noteOn(int note, int velocity) noexcept;
    void liftHand() noexcept { handIsDown = false; }

    /// Call at each grid point, after the glide has moved. `beats` is the song position at this
    /// point; the tempo is 0 if there is none.
    void beginCell(double beatsPerMinute, std::optional<double> beats) noexcept;

    bool moves(ParameterId target) const noexcept {
        return routes.moves(target) || hostMoves(target);
    }
    /// Returns the glide's values as modulated for all notes: sources of notes are those of the
    /// last one, and steps of sources are rounded within some milliseconds. Leaves out `tune`,
    /// which acts on slots. Valid until the next call or a change of the glide.
    const ParameterValues& values() noexcept;
    /// Returns them as modulated for one note, at once. Valid likewise.
    const ParameterValues& valuesOf(int note) noexcept;
    /// Returns one parameter of a note, also `tune`.
    double valueOf(ParameterId target, int note) const noexcept;

    /// Returns by how much `valueOf` moves the parameter, in its unit.
    double shiftOf(ParameterId target, int note) const noexcept {
        return valueOf(target, note) - glide.values()[target];
    }

    /// Sets the number of the next note, from 0 on. It seeds the random source.
    void countFrom(std::uint32_t number) noexcept { noteCount = firstNumber + number; }
    /// Restarts LFOs, envelopes and the count of notes.
    void reset() noexcept;

private:
    struct Note {
        std::uint32_t number = 0;
        double velocity = 0; ///< 0 to 1
        std::array<double, 2> swingsAtStart{};
        NoteEnvelope envelope;
    };

    bool hostMoves(ParameterId target) const noexcept;
    double hostShare(ParameterId target, int note) const noexcept;
    void glideTuneShares() noexcept;
    double sourceOf(const ActiveRoute& route, int note) const noexcept;
    double lfoOf(std::size_t lfo, const Note& note) const noexcept;
    ActiveRoutes::Inputs inputsOf(int note) const noexcept;
    const ParameterValues& moved(const ActiveRoutes::Inputs& inputs) noexcept;
    void beginLfos(double beatsPerMinute, std::optional<double> beats) noexcept;
    void roundInputs() noexcept;
    void advanceEnvelopes() noexcept;

    const ParameterGlide& glide;
    const KeyState& keys;
    double cellSeconds, roundingShare, glideShare;
    std::uint32_t firstNumber, noteCount;
    std::array<Lfo, 2> lfos;
    std::array<Note, hand + 1> notes;
    int lastNote = hand;
    bool handIsDown = false;
    bool isFresh = true;
    ActiveRoutes routes;                 ///< of the newest cell
    ActiveRoutes::Inputs sharedInputs{}; ///< of all notes, in the newest cell
    const NoteShifts* hostShifts;
    std::array<double, hand> tuneShares{}; ///< gliding towards the host's
    bool hasTuneShares = false;            ///< any of them is not 0
    ParameterValues result;
};

} // namespace idiophone
