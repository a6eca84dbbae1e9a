// Plays an instrument from MIDI: notes become strikes or held contacts, pedals and releases become
// dampers, and the synthesiser's cells become a stream of any block size.
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

/// A channel message; `sampleOffset` counts from the start of the block it is handed over with.
struct MidiEvent {
    int sampleOffset = 0;
    std::array<std::uint8_t, 3> bytes{};

    bool isNoteOn() const { return (bytes[0] & 0xf0) == 0x90 && (bytes[2] & 0x7f) > 0; }
    bool isNoteOff() const {
        return (bytes[0] & 0xf0) == 0x80 || ((bytes[0] & 0xf0) == 0x90 && !isNoteOn());
    }
};

/// A blow on a place of an object beside the keys, such as a click on its picture.
struct SurfaceStrike {
    std::size_t slot = 0; ///< of the instrument
    StrikePoint point;    ///< on the slot's object
    int velocity = 0;     ///< 1 to 127; 0 strikes nothing and lifts the hand
};

/// Constructed and destroyed off the audio thread; the rest is for the audio thread and neither
/// allocates, locks nor throws. The same events and parameters give the same samples, bit for bit,
/// whatever the block sizes.
class Player {
public:
    /// The surface, which is valid, is what scrapes and rolls sound like. The seed says where their
    /// noise begins, and how strikes spread and chatter. `own` are the preset's values, whose
    /// loudness "match loudness" keeps.
    Player(std::shared_ptr<const Instrument> instrument,
           double sampleRateHz,
           const Surface& surface = {},
           std::uint64_t seed = 1,
           const ParameterValues& own = {});
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    /// Has the gain that matches the loudness of these values from the first cell on, whatever it
    /// costs, with the modulation wheel at rest or where it is about to be, 0 to 127: off the audio
    /// thread, between construction or `reset` and the first block. What was never prepared is made
    /// good within the first cell.
    void prepare(const ParameterValues& parameters,
                 int awaitedWheel = HeldContacts::controllerAtRest);
    /// Where the modulation wheel is.
    int modulationWheel() const noexcept { return loudness.speedController(); }

    /// Renders the next `output.size()` samples (full scale 1, before `width` and `level`). Without
    /// radiation both channels are the same. Events are in order of time; what is stamped beyond
    /// the block's end acts at the next block's start. Strikes act at their sample; parameters and
    /// everything else at the first point of the 64-sample grid at or after their stamp, which for
    /// parameters is the block's first sample; from there what sounds while it moves glides. On a
    /// stage notes set bodies in motion at their sample, and blows by hand act at the next grid
    /// point.
    void process(const StereoSpan& output,
                 std::span<const MidiEvent> events,
                 const ParameterValues& parameters);

    /// Acts at the first sample of the next block that has one. From the blow until the hand is
    /// lifted the object is held as by a key. What this instrument does not have is ignored.
    void strikeSurface(const SurfaceStrike& strike);

    /// Drags a hand over a surface, whatever the keys do; acts at the first grid point of the next
    /// block. Until it is lifted the object is held as by a key. What this instrument does not have
    /// is ignored.
    void scrapeSurface(const SurfaceTouch& touch);

    /// All hands leave all surfaces.
    void liftHands();

    /// Acts at the first grid point of the next block, or from the first one on where none was
    /// rendered; a `reset` changes nothing.
    void setSilencedModes(const SilencedModes& silenced);

    /// Acts as `setSilencedModes` does. Keys without a pitch play nothing.
    void setTuning(const KeyTuning& tuning) { slotTuning.setTuning(tuning); }
    /// By how much tunings and wheels may have any slot below its key in equal temperament.
    double semitonesBelowEqual() const noexcept {
        return slotTuning.semitonesBelowEqual() + bend.farthestSemitones();
    }

    /// Whether a key without an object of its own was ever played.
    bool hasPlayedResizedKeys() const noexcept { return playedResizedKeys; }

    /// Pedals, wheels and other controllers stand as another player's do, whose keys this one does
    /// not have.
    void takeControllersOf(const Player& former) noexcept;
    /// Of these only MPE's zones and the bend ranges.
    void takeBendSetupOf(const Player& former) noexcept;
    /// See PitchBend.
    PitchBend::Given takeGivenBends() noexcept { return bend.takeGiven(); }
    void forgetGivenBends() noexcept { bend.forgetGiven(); }

    /// On a stage: whether `process` may wait for what its bodies do.
    void setOffline(bool isOffline) noexcept;
    /// On a stage: bodies stand still, or are as they were before the first note.
    void pauseStage(bool isPaused) noexcept;
    void resetStage() noexcept;
    /// What its bodies struck since this was asked last; valid until the next `process`.
    std::span<const PlacedBlow> takeBlows() noexcept;
    std::uint32_t performanceNumber() const noexcept; ///< StagePerformance::number, or 0
    /// Of the slots, where their bodies are; empty where there is no stage.
    std::span<const BodyPose> bodyPoses() const noexcept;
    /// Blows of a stage's bodies that became known too late to act at their time.
    std::int64_t lateBlows() const noexcept;

    /// The host's, from the next cell on; 0 where it tells none.
    void setTempo(double beatsPerMinute) { tempo = beatsPerMinute; }
    /// Where the song is at the next sample, in beats, while it plays and the host tells; it goes
    /// on from there in its tempo. A motor in that tempo keeps to it.
    void setSongPlace(std::optional<double> beats) { songPlace = beats; }
    /// The song begins to play at its place, or goes back to it: strikes are counted anew from a
    /// number of that place's, and where nothing sounds or moves all but keys and
    /// controllers is as at the start. So the same events there sound the same to the last bit.
    /// Returns whether it is.
    bool beginSong();

    /// Silence, all keys up, controllers at rest, the grid at its start. MPE's zones and the bend
    /// ranges stay as MIDI has set them.
    void reset();

    /// What its owner knows it by; 0 until it is given one.
    void setLabel(std::int64_t given) noexcept { ownersLabel = given; }
    std::int64_t label() const noexcept { return ownersLabel; }

    bool silent() const;
    /// For what sounds on behind the player, where "all sound off" came since this was asked or no
    /// blow has followed it yet: how many samples at the start of the last block are what it
    /// silences. It is taken to act there: who wants it at its sample begins a block with it.
    std::optional<std::size_t> takeSilenced();
    const Synthesiser& synthesiser() const { return synth; }
    const Instrument& instrument() const { return *playedInstrument; }
    /// Of the key or the blow that came last; nothing before the first one.
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
    void prepareBlows();
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
    std::unique_ptr<StagePerformance> performance; ///< of an instrument on a stage
    AlignedVector<float> slotSamples;              ///< [slots, 64] on a stage
    std::vector<CellOutput> slotCells; ///< where each slot sounds: in those, or all in the one cell
    int cellPosition = cellSamples;
    std::int64_t cellIndex = -1; ///< of the cell begun last
    std::uint32_t firstStrikeNumber;
    std::uint32_t strikeCount;
    CellStrikes pending;
    std::vector<MidiEvent> late;               ///< note-ons for the start of the next block
    std::vector<SurfaceStrike> surfaceStrikes; ///< for the start of the next block
    std::vector<LowestModes> lowestModes;      ///< of each slot
    std::vector<KeyMallet> mallets;            ///< of each slot, as its keys have it
    HeldContacts held;
    HandScrape handScrape;
    std::optional<std::size_t> playedLast;

    LoudnessMatch loudness;
    Motor motor;
    double tempo = 0;                             ///< beats a minute, or 0
    std::optional<double> songPlace;              ///< in beats
    float gainAtCellStart = 1, gainAtCellEnd = 1; ///< that matches; it is linear in between

    std::array<std::bitset<128>, 16> keysDown; ///< of each channel
    std::bitset<128> keysSustained;            ///< released under the sustain pedal
    std::bitset<128> keysCaught;               ///< down when the sostenuto pedal went down
    bool sustainPedal = false;
    bool sostenutoPedal = false;
    double softness = 1; ///< of the soft pedal: times the mallet's speed
    PitchBend bend;
    SlotTuning slotTuning;
    std::array<std::array<float, 128>, 16> keyPressures{}; ///< 0 to 1, of each channel's keys
    std::array<float, 128> notePressures{};                ///< the most of them, of each note
    std::vector<bool> slotTouched;                         ///< a hand on its surface holds it
    std::vector<bool> slotHeld; ///< that, or some key of it is down or sustained, or it may ring
    std::vector<float> slotPressed; ///< the most that one of its keys presses
    bool playedResizedKeys = false;
    bool isSilenced = false; ///< by "all sound off", until the next blow
    /// What rang until that blow goes on in the next cell, laid out as the cells of slots are.
    AlignedVector<float> remains;
    std::vector<CellOutput> remainsOfSlots;
    bool hasRemains = false;
    bool allSoundOffCame = false;
    std::size_t silencedSamples = 0; ///< of the last block
};

} // namespace idiophone
