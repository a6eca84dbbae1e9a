// Plays an instrument from MIDI. Notes become strikes or sustained contacts, pedals and releases
// become dampers, and the synthesiser's cells become a stream of any block size.
#pragma once

#include "Instrument/CellRenderer.h"
#include "Instrument/HandScrape.h"
#include "Instrument/HeldContacts.h"
#include "Instrument/InputForce.h"
#include "Instrument/Instrument.h"
#include "Instrument/KeyState.h"
#include "Instrument/MatchedGain.h"
#include "Instrument/MidiEvent.h"
#include "Instrument/Modulation.h"
#include "Instrument/ParameterGlide.h"
#include "Instrument/SilencedModes.h"
#include "Instrument/SlotModulation.h"
#include "Instrument/SlotTuning.h"
#include "Instrument/StereoSpan.h"
#include "Instrument/StrikeScheduler.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace idiophone {

/// Constructed and destroyed off the audio thread; the rest is for the audio thread and neither
/// allocates, locks nor throws. The same events and parameters give the same samples, bit for bit,
/// for all block sizes.
class Player {
public:
    /// `surface` must be valid; scrapes and rolls sound like it. The seed decides where their noise
    /// begins, and how strikes spread and chatter. `own` are the preset's values, whose loudness
    /// "match loudness" keeps.
    Player(std::shared_ptr<const Instrument> instrument,
           double sampleRateHz,
           const Surface& surface = {},
           std::uint64_t seed = 1,
           const ParameterValues& own = {});
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    /// Applies these values to all objects and predicts the gain that matches their loudness, so
    /// that the first cell need not.
    /// `pendingWheel`, 0 to 127, is the position that the modulation wheel is about to have. Call
    /// it off the audio thread, between construction or `reset` and the first block; it may take
    /// long.
    void prepare(const ParameterValues& parameters,
                 int pendingWheel = HeldContacts::controllerAtRest);
    /// Sets whether it may wait for what is late in real time, for the same bits in each render:
    /// the gain that matches loudness is predicted at the grid point where it changes, and a stage
    /// waits for its simulation. Not at first.
    void setOffline(bool isOffline) noexcept;
    /// Returns the gain that matches loudness, or null on a stage. In real time another thread has
    /// to call its `answer` every now and then; until then the gain stays as it is.
    const std::shared_ptr<MatchedGain>& matchedGain() const noexcept { return loudness; }
    /// Returns the position of the modulation wheel.
    int modulationWheel() const noexcept { return keys.modulationWheel(); }

    /// Renders the next samples of the connected outputs (full scale 1, before `width` and
    /// `level`), of which the main one is the first. There are at most `maximumOutputs`, all
    /// equally long or not connected (`connectedOutputs`). Without radiation both channels are the
    /// same.
    /// Events are in order of time; those beyond the block's end act at the start of the next
    /// block. Strikes act at their sample. All else acts at the first point of the 64-sample grid
    /// at or after its time; for parameters that time is the block's first sample. From there
    /// gliding parameters glide.
    /// On a stage notes move bodies at their sample, and strikes by hand act at the next grid
    /// point.
    /// `input` (mono, full scale 1) presses on the object of the last key, at its own sample. It
    /// is as long as the output, or empty. A stage does not hear it.
    void process(std::span<const StereoSpan> outputs,
                 std::span<const MidiEvent> events,
                 const ParameterValues& parameters,
                 std::span<const float> input = {});
    /// Renders the main output only.
    void process(const StereoSpan& output,
                 std::span<const MidiEvent> events,
                 const ParameterValues& parameters,
                 std::span<const float> input = {}) {
        process(std::span(&output, 1), events, parameters, input);
    }

    /// Strikes at the first sample of the next non-empty block. From the strike until the hand
    /// lifts, the object is held as by a key. Ignores slots and rows that this instrument does not
    /// have.
    void strikeSurface(const SurfaceStrike& strike);

    /// Drags a hand over a surface, independently of the keys; acts at the first grid point of the
    /// next block. Until the hand lifts, the object is held as by a key. Ignores slots and rows
    /// that this instrument does not have.
    void scrapeSurface(const SurfaceTouch& touch);

    /// Moves parameters of single notes, on top of all else that moves them. The shifts must
    /// outlive the last block.
    void follow(const NoteShifts& shifts) noexcept { modulation.follow(shifts); }
    /// Returns whether an object that the note was the last to play rings. True while strikes are
    /// pending or bodies move.
    bool sounds(int note) const noexcept {
        return !scheduler.silent() || !lateNotes.empty() ||
               (performance && !performance->silent()) ||
               slotModulation.sounds(note, synthesiser());
    }

    /// Lifts all hands from all surfaces.
    void liftHands() { renderer.liftHands(); }

    /// Acts at the first grid point of the next block, or at the very first one if nothing has been
    /// rendered. `reset` keeps it.
    void setSilencedModes(const SilencedModes& silenced) { renderer.setSilencedModes(silenced); }

    /// Acts as `setSilencedModes` does. Keys without a pitch play nothing.
    void setTuning(const KeyTuning& tuning) { slotTuning.setTuning(tuning); }
    /// Returns the maximum by which tunings and wheels may lower a slot below its key in equal
    /// temperament.
    double semitonesBelowEqual() const noexcept {
        return slotTuning.semitonesBelowEqual() + keys.bend().maximumSemitones();
    }

    /// Returns whether a key without an object of its own was ever played.
    bool hasPlayedResizedKeys() const noexcept { return playedResizedKeys; }

    /// Takes over the pedals, wheels and other controllers of another player, but not its keys.
    void takeControllersOf(const Player& former) noexcept;
    PitchBend& bend() noexcept { return keys.bend(); }

    /// Sets the host's tempo from the next cell on, 0 if it gives none, and the song position at
    /// the next sample, in beats, while the host plays and gives one. The position advances with
    /// the tempo. A motor in that tempo follows it.
    void setSong(double beatsPerMinute, std::optional<double> beats) {
        tempo = beatsPerMinute;
        songPlace = beats;
    }
    /// Marks that the transport started or looped. Reseeds the strike counter from the song
    /// position, so that every pass renders the same samples. If nothing sounds or moves, also
    /// resets everything except keys and controllers, so that the passes are equal to the last
    /// bit. Returns whether it did so.
    bool beginSong();

    /// Silences everything, releases all keys, resets controllers and restarts the grid. Keeps
    /// the zones and bend ranges that MIDI has set.
    void reset();

    /// Sets the owner's identifier of this player; 0 at first.
    void setLabel(std::int64_t given) noexcept { ownersLabel = given; }
    std::int64_t label() const noexcept { return ownersLabel; }

    bool silent() const;
    /// Returns how many samples at the start of the last block All Sound Off silences, for effects
    /// behind the player such as the room. Returns nothing if it neither came since the last call
    /// nor silenced any sample of the last block. All Sound Off counts from the block's start; for
    /// the exact sample, begin a block there.
    std::optional<std::size_t> takeSilenced();
    const Synthesiser& synthesiser() const { return renderer.synthesiser(); }
    const Instrument& instrument() const { return *playedInstrument; }
    /// Returns the stage; without one nothing is on it.
    PlayedStage& stage() noexcept { return performance ? *performance : noStage; }
    const PlayedStage& stage() const noexcept { return performance ? *performance : noStage; }
    /// Returns the slot of the last key or strike; nothing before the first.
    std::optional<std::size_t> slotPlayedLast() const { return playedLast; }
    /// Returns the velocity of the last strike by a mallet, 1 to 127; 0 before the first.
    int velocityStruckLast() const { return scheduler.velocityStruckLast(); }

private:
    std::span<const MidiEvent> follow(std::span<const MidiEvent> eventsOfOneSample);
    void follow(const MidiEvent& event);
    void beginNote(int note, int velocity);
    void beginOn(std::size_t slot, int note);
    void beginCell(std::optional<double> beats);
    void strike(std::span<const MidiEvent> notes);
    void restart();

    std::int64_t ownersLabel = 0;
    std::shared_ptr<const Instrument> playedInstrument; ///< outlives the performance's own thread
    std::unique_ptr<StagePlayer> performance;           ///< null if mallets play
    PlayedStage noStage;
    ParameterGlide glide;
    HeldContacts held;
    HandScrape hand;
    InputForce inputForce;
    KeyState keys;
    Modulation modulation;
    SlotTuning slotTuning;
    SlotModulation slotModulation;
    StrikeScheduler scheduler;
    CellRenderer renderer;
    std::shared_ptr<MatchedGain> loudness; ///< null on a stage
    std::vector<MidiEvent> lateNotes;      ///< note-ons for the start of the next block
    double tempo = 0;                      ///< beats a minute, or 0
    std::optional<double> songPlace;       ///< in beats
    std::optional<std::size_t> playedLast;
    bool mayWait = false; ///< offline
    bool playedResizedKeys = false;
    bool allSoundOffCame = false;
    std::size_t silencedSamples = 0; ///< in the last block
};

} // namespace idiophone
