// Plays an instrument from MIDI. Notes become strikes or sustained contacts, pedals and releases
// become dampers, and the synthesiser's cells become a stream of any block size.
#pragma once

#include "Instrument/CellStrikes.h"
#include "Instrument/HandScrape.h"
#include "Instrument/HeldContacts.h"
#include "Instrument/Instrument.h"
#include "Instrument/LoudnessMatch.h"
#include "Instrument/LowestModes.h"
#include "Instrument/Motor.h"
#include "Instrument/ParameterGlide.h"
#include "Instrument/PitchBend.h"
#include "Instrument/SilencedModes.h"
#include "Instrument/SlotTuning.h"
#include "Instrument/StereoSpan.h"
#include "Parameters/ParameterTable.h"
#include "Synth/AlignedVector.h"
#include "Synth/Synthesiser.h"

#include <array>
#include <bitset>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace idiophone {

/// A channel message; `sampleOffset` counts from the start of its block.
struct MidiEvent {
    int sampleOffset = 0;
    std::array<std::uint8_t, 3> bytes{};

    bool isNoteOn() const { return (bytes[0] & 0xf0) == 0x90 && (bytes[2] & 0x7f) > 0; }
    bool isNoteOff() const {
        return (bytes[0] & 0xf0) == 0x80 || ((bytes[0] & 0xf0) == 0x90 && !isNoteOn());
    }
};

/// A strike at a place of an object without a key, such as a click on its picture.
struct SurfaceStrike {
    std::size_t slot = 0; ///< index into the instrument's slots
    StrikePoint point;    ///< on the slot's object
    int velocity = 0;     ///< 1 to 127; 0 strikes nothing and lifts the hand
};

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

    /// Computes the gain that matches the loudness of these values, so that the first cell has it.
    /// `awaitedWheel`, 0 to 127, is the position that the modulation wheel is about to have. Call
    /// it off the audio thread, between construction or `reset` and the first block; it may take
    /// long. Without it the first cell computes the gain.
    void prepare(const ParameterValues& parameters,
                 int awaitedWheel = HeldContacts::controllerAtRest);
    /// Returns the position of the modulation wheel.
    int modulationWheel() const noexcept { return loudness.speedController(); }

    /// Renders the next `output.size()` samples (full scale 1, before `width` and `level`). Without
    /// radiation both channels are the same.
    /// Events are in order of time; those beyond the block's end act at the start of the next
    /// block. Strikes act at their sample. All else acts at the first point of the 64-sample grid
    /// at or after its time; for parameters that time is the block's first sample. From there
    /// gliding parameters glide.
    /// On a stage notes move bodies at their sample, and strikes by hand act at the next grid
    /// point.
    void process(const StereoSpan& output,
                 std::span<const MidiEvent> events,
                 const ParameterValues& parameters);

    /// Strikes at the first sample of the next non-empty block. From the strike until the hand
    /// lifts, the object is held as by a key. Ignores slots and rows that this instrument does not
    /// have.
    void strikeSurface(const SurfaceStrike& strike);

    /// Drags a hand over a surface, independently of the keys; acts at the first grid point of the
    /// next block. Until the hand lifts, the object is held as by a key. Ignores slots and rows
    /// that this instrument does not have.
    void scrapeSurface(const SurfaceTouch& touch);

    /// Lifts all hands from all surfaces.
    void liftHands();

    /// Acts at the first grid point of the next block, or at the very first one if nothing was
    /// rendered yet. `reset` keeps it.
    void setSilencedModes(const SilencedModes& silenced);

    /// Acts as `setSilencedModes` does. Keys without a pitch play nothing.
    void setTuning(const KeyTuning& tuning) { slotTuning.setTuning(tuning); }
    /// Returns the maximum by which tunings and wheels may lower a slot below its key in equal
    /// temperament.
    double semitonesBelowEqual() const noexcept {
        return slotTuning.semitonesBelowEqual() + bend.farthestSemitones();
    }

    /// Returns whether a key without an object of its own was ever played.
    bool hasPlayedResizedKeys() const noexcept { return playedResizedKeys; }

    /// Takes over the pedals, wheels and other controllers of another player, but not its keys.
    void takeControllersOf(const Player& former) noexcept;
    /// Takes over only MPE's zones and the bend ranges.
    void takeBendSetupOf(const Player& former) noexcept;
    /// See PitchBend.
    PitchBend::Given takeGivenBends() noexcept { return bend.takeGiven(); }
    void forgetGivenBends() noexcept { bend.forgetGiven(); }

    /// On a stage: sets whether `process` may wait for the simulation.
    void setOffline(bool isOffline) noexcept;
    /// On a stage: see StagePlayer::waitForSimulation.
    void waitForSimulation() noexcept;
    /// On a stage: stops bodies in place, or returns them to their state before the first note.
    void pauseStage(bool isPaused) noexcept;
    void resetStage() noexcept;
    /// Returns the impacts of the stage's bodies since the last call; valid until the next
    /// `process`.
    std::span<const PlacedImpact> takeImpacts() noexcept;
    std::uint32_t performanceNumber() const noexcept; ///< StagePlayer::number, or 0
    /// Returns where the bodies of the slots are; empty without a stage.
    std::span<const BodyPose> bodyPoses() const noexcept;
    /// Returns the number of impacts and contacts of a stage's bodies that became known too late to
    /// act at their time.
    std::int64_t lateEvents() const noexcept;

    /// Sets the host's tempo from the next cell on; 0 if it gives none.
    void setTempo(double beatsPerMinute) { tempo = beatsPerMinute; }
    /// Sets the song position at the next sample, in beats, while the host plays and gives one. It
    /// advances with the tempo. A motor in that tempo follows it.
    void setSongPlace(std::optional<double> beats) { songPlace = beats; }
    /// Marks that the transport started or looped. Reseeds the strike counter from the song
    /// position, so that every pass renders the same samples. If nothing sounds or moves, it also
    /// returns everything but keys and controllers to the start, which makes the passes equal to
    /// the last bit. Returns whether it did.
    bool beginSong();

    /// Silences everything, releases all keys, returns controllers to rest and the grid to its
    /// start. MPE's zones and the bend ranges stay as MIDI has set them.
    void reset();

    /// Sets the owner's identifier of this player; 0 at first.
    void setLabel(std::int64_t given) noexcept { ownersLabel = given; }
    std::int64_t label() const noexcept { return ownersLabel; }

    bool silent() const;
    /// Tells effects behind the player, such as the room, about All Sound Off. Returns the number
    /// of samples at the start of the last block that it silences. Returns nothing if it neither
    /// came since the last call nor silenced any sample of the last block. All Sound Off counts
    /// from the block's start; for the exact sample, begin a block there.
    std::optional<std::size_t> takeSilenced();
    const Synthesiser& synthesiser() const { return synth; }
    const Instrument& instrument() const { return *playedInstrument; }
    /// Returns the slot of the last key or strike; nothing before the first.
    std::optional<std::size_t> slotPlayedLast() const { return playedLast; }

private:
    std::span<const MidiEvent> follow(std::span<const MidiEvent> events);
    void follow(const MidiEvent& event);
    void pressNewKeys(std::span<const MidiEvent> events);
    void strikeFor(const MidiEvent& event);
    void strikeAt(std::size_t slot,
                  const StrikePoint& point,
                  int velocity,
                  const KeyMallet& mallet,
                  std::uint32_t number);
    void strikeWaiting();
    void keyDown(int channel, int note, int velocity);
    void keyUp(int channel, int note);
    void letGo(int channel, int note);
    void press(int channel, int note, double pressure);
    void press(int channel, double pressure);
    void setKeyPressure(int channel, std::size_t note, double pressure);
    void forgetPressures();
    void controller(int channel, int number, int value);
    void catchKeys(bool isDown);
    void liftPedals();
    void schedule(std::size_t slot, double sample, const Strike& strike);
    void strikePendingBefore(double sampleInCell);
    void beginCell(std::optional<double> beats);
    void prepareStrikes();
    SynthesisSettings settingsNow() const;
    void soundCell(const CellOutput& mixed, std::span<const CellOutput> cellsOfSlots);
    void forgetSilenced();
    void addRemains();
    void updateDampers();
    void turnMotor(std::optional<double> beats);
    void updateGain();
    void forgetSound();
    void copyOut(const StereoSpan& output, int position, int count) const;
    CellOutput cell() { return {leftCell, rightCell}; }
    BegunCell begunCell() { return {synth, slotCells, cellIndex}; }
    void playStage();
    double nextStrikeSample() const;

    std::shared_ptr<const Instrument> playedInstrument;
    std::int64_t ownersLabel = 0;
    Synthesiser synth;
    ParameterValues current;
    ParameterGlide glide;
    alignas(64) std::array<float, cellSamples> leftCell{};
    alignas(64) std::array<float, cellSamples> rightCell{};
    std::unique_ptr<StagePlayer> performance; ///< for an instrument on a stage
    AlignedVector<float> slotSamples;         ///< [slots, 64] on a stage
    std::vector<CellOutput>
        slotCells; ///< output of each slot: its own in slotSamples, or the one cell
    int cellPosition = cellSamples;
    std::int64_t cellIndex = -1; ///< index of the newest cell
    std::uint32_t firstStrikeNumber;
    std::uint32_t strikeCount;
    CellStrikes pending;
    std::vector<MidiEvent> late;               ///< note-ons for the start of the next block
    std::vector<SurfaceStrike> surfaceStrikes; ///< for the start of the next block
    std::vector<LowestModes> lowestModes;      ///< of each slot
    std::vector<KeyMallet> mallets;            ///< of each slot, from its keys
    HeldContacts held;
    HandScrape handScrape;
    std::optional<std::size_t> playedLast;

    LoudnessMatch loudness;
    Motor motor;
    double tempo = 0;                             ///< beats a minute, or 0
    std::optional<double> songPlace;              ///< in beats
    float gainAtCellStart = 1, gainAtCellEnd = 1; ///< matching gain; linear in between

    std::array<std::bitset<128>, 16> keysDown; ///< [channel][note]
    std::bitset<128> keysSustained;            ///< released under the sustain pedal
    std::bitset<128> keysCaught;               ///< down when the sostenuto pedal went down
    bool sustainPedal = false;
    bool sostenutoPedal = false;
    double softness = 1; ///< soft pedal's factor of the mallet's speed
    PitchBend bend;
    SlotTuning slotTuning;
    std::array<std::array<float, 128>, 16> keyPressures{}; ///< 0 to 1, of each channel's keys
    std::array<float, 128> notePressures{};                ///< [note] maximum over channels
    std::vector<bool> slotTouched;                         ///< a hand on its surface holds it
    std::vector<bool> slotHeld;     ///< touched, or a key is down or sustained, or it may ring
    std::vector<float> slotPressed; ///< maximum pressure of its keys
    bool playedResizedKeys = false;
    bool isSilenced = false; ///< by All Sound Off, until the next strike
    /// The old sound after that strike, for the next cell; laid out as the cells of slots are.
    AlignedVector<float> remains;
    std::vector<CellOutput> remainsOfSlots;
    bool hasRemains = false;
    bool allSoundOffCame = false;
    std::size_t silencedSamples = 0; ///< in the last block
};

} // namespace idiophone
