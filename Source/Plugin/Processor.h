// Implements the plugin that a host drives. Joins parameters, MIDI, the player and the output
// stage; Instrument and Synth make the sound.
#pragma once

#include "Editor/ProcessorView.h"
#include "Editor/SettingsFolder.h"
#include "Instrument/DecayBounds.h"
#include "Output/OutputStage.h"
#include "Plugin/BlockPieces.h"
#include "Plugin/GuardedTimer.h"
#include "Plugin/Handoff.h"
#include "Plugin/HostParameters.h"
#include "Plugin/HostTransport.h"
#include "Plugin/LatestValue.h"
#include "Plugin/MidiLearn.h"
#include "Plugin/ModeSilencer.h"
#include "Plugin/NoteQueue.h"
#include "Plugin/ObjectWorkshop.h"
#include "Plugin/PendingKeys.h"
#include "Plugin/PlayerCrossfade.h"
#include "Plugin/PresetCollection.h"
#include "Plugin/SharedFigures.h"
#include "Plugin/SoundHistory.h"
#include "Plugin/SoundMonitor.h"
#include "Plugin/SoundPicture.h"
#include "Plugin/StageCapture.h"
#include "Plugin/State.h"
#include "Plugin/SurfaceHand.h"
#include "Plugin/Tuner.h"

#include <functional>
#include <juce_audio_processors/juce_audio_processors.h>
#include <juce_events/juce_events.h>
#include <mutex>
#include <span>

namespace idiophone {

/// Threads: in real time `processBlock` neither allocates, locks nor calls the system. Everything
/// that changes the sound (states, programs, `prepareToPlay`) may come from any other thread and
/// takes `soundMutex`. The audio thread never takes it and gets finished players through the
/// handoff. A program that MIDI asks for is loaded by a message-thread timer some 50 ms later. In
/// an offline render the callback loads it between two blocks.
class Processor final : public juce::AudioProcessor, public ProcessorView, public SoundHolder {
public:
    Processor();
    ~Processor() override;

    const juce::String getName() const override { return "Idiophone"; }
    bool acceptsMidi() const override { return true; }
    bool producesMidi() const override { return false; }
    bool supportsMPE() const override { return true; }

    bool isBusesLayoutSupported(const BusesLayout& layouts) const override;
    void prepareToPlay(double sampleRateHz, int maximumBlockSize) override;
    void releaseResources() override;
    void reset() override;
    void setNonRealtime(bool isOffline) noexcept override;
    void processBlock(juce::AudioBuffer<float>& buffer, juce::MidiBuffer& midi) override;
    using AudioProcessor::processBlock;

    juce::AudioProcessorParameter* getBypassParameter() const override;
    /// Returns the tail in seconds: the time that a stage's bodies move, plus the decay of the
    /// lowest mode by 96 dB (one 16-bit step), plus the decay of the room by as much. Takes the
    /// mode as low as wheels may bend it. At most `longestTailSeconds`: lightly damped objects ring
    /// for minutes, and hosts would render as long. Ignores dampers, whatever `let_ring` is: pedals
    /// hold released keys, and many hosts ask only once.
    double getTailLengthSeconds() const override;
    static constexpr double longestTailSeconds = 120;

    /// Returns the number of factory presets. A VST3 has 128 programs, as many as MIDI numbers: the
    /// presets, then unused programs that do nothing. The last one stands for any other sound.
    int getNumPrograms() override;
    static constexpr int vst3Programs = 128;
    int getCurrentProgram() override;
    void setCurrentProgram(int index) override;
    const juce::String getProgramName(int index) override;
    void changeProgramName(int, const juce::String&) override {} // factory presets keep their names

    void getStateInformation(juce::MemoryBlock& destination) override;
    /// Returns with the instrument ready: the next block plays it. A state that cannot be restored
    /// changes nothing and shows one sentence in the status line.
    void setStateInformation(const void* bytes, int byteCount) override;

    bool hasEditor() const override { return true; }
    juce::AudioProcessorEditor* createEditor() override;

    double parameterValue(ParameterId parameter) const override;
    double effectiveValue(ParameterId parameter) const override;
    void makeCustom(ParameterId figure) override;
    bool isLive(ParameterId parameter) const override;
    void beginParameterChange(ParameterId parameter) override;
    void changeParameter(ParameterId parameter, double value) override;
    void endParameterChange(ParameterId parameter) override;
    std::vector<std::string> readUserMaterials() override;
    std::vector<std::string> userMaterialNames() const override;
    int userMaterialIndex() const override;
    void chooseUserMaterial(int index) override;
    void playNote(int midiNote, int velocity) override;
    KeyRange keyRange() const override;
    std::array<KeySound, 128> keySounds() const override;
    std::vector<PlayedObject> playedObjects() const override;
    bool hasStage() const override;
    std::vector<BodyNow> stageBodies() const override;
    void pauseStage(bool isPaused) override { stagePaused = isPaused; }
    bool isStagePaused() const override { return stagePaused; }
    void resetStage() override;
    bool hasCaptured() override;
    bool writeCapture(CaptureKind kind, const std::filesystem::path& file) override;
    std::vector<std::array<double, 3>> struckPlaces(std::size_t index) const override;
    int instrumentNumber() const override { return loads; }
    void strikeObject(std::size_t index,
                      const std::array<double, 3>& pointMetres,
                      int velocity) override;
    void scrapeObject(std::size_t index,
                      const std::array<double, 3>& pointMetres,
                      double pressure) override;
    const SoundFrame* takeSoundFrame() override;
    void watchObject(std::optional<std::size_t> object) override;
    std::optional<std::size_t> watchedObject() const override { return watched; }
    bool muteMode(std::size_t object, std::int32_t mode, bool isMuted) override;
    bool hearModeAlone(std::size_t object, std::int32_t mode, bool isAlone) override;
    void unmuteModes(std::size_t object) override;
    void hearAllModes(std::size_t object) override;
    Status takeStatus() override;
    bool playsPreview() const override;
    void reportError(const std::string& sentence) override;
    PresetCollection& presetShelf() override { return shelf; }
    SoundHistory& editHistory() override { return history; }
    SoundHistory& soundVariants() override { return history; }
    MidiLearn& midiLearn() override { return controllers; }
    void windowClosed() override;

    Sound loadedSound() const override;
    SoundLabel loadedLabel() const override;
    bool playSound(const Sound& wanted) override;
    void relabel(const Sound& wanted) override;
    int hostLoads() const override { return loadsByHost; }
    std::optional<Sound> takeSoundBeforePrograms() override;
    void changeParameters(const Sound& of, const ParameterValues& wanted) override;
    void setValue(ParameterId parameter, double value) override;

    bool isTuningFile(const std::filesystem::path& file) const override;
    std::string tuningPatterns() const override;
    void openTuning(const std::filesystem::path& file) override;
    void forgetTuning() override;
    TuningStatus tuningStatus() const override;

    bool canOpen(const std::filesystem::path& file) const override;
    std::string openPatterns() const override;
    void openFile(const std::filesystem::path& file) override;
    bool canAnalyseAgain() const override;
    void setImportSettings(const ImportSettings& settings) override;
    void analyseAgain() override;
    void cancelImport() override { workshop.cancel(); }
    ImportStatus importStatus() const override;
    std::optional<KeyLayout> keyLayout() const override;
    void setKeyLayout(KeyLayout layout) override;
    void setStrikePath(std::size_t index,
                       const std::vector<std::array<double, 3>>& pathMetres) override;

    /// [message side] Returns the playing instrument, or null if none could be loaded.
    std::shared_ptr<const Instrument> loadedInstrument() const;
    /// [any thread] Returns how often the output was not finite. Each time it was silenced and the
    /// player reset.
    std::int64_t timesNotFinite() const { return notFinite; }
    /// [message thread] Returns whether the host calls `processBlock`. Otherwise the window's
    /// strikes are refused: all would wait and sound at once when the host goes on.
    bool isProcessing() const;
    /// [message thread] Polls the audio thread and the workshop. A timer calls it every
    /// `pollMilliseconds`.
    void poll();
    /// [any thread, between two callbacks] See StagePlayer::waitForSimulation.
    void waitForSimulation();

private:
    static constexpr int pollMilliseconds = 50;

    void followProgramChange();
    void chooseProgram(int index, std::int64_t request);
    Result<bool> loadProgram(int index, std::int64_t request);
    void tellOfSound();
    void lookForCallbacks(); ///< notes when callbacks came, for `isProcessing`
    void changeByHand(const ParameterValues& wanted, std::span<const ParameterId> changed);
    Result<void> restore(const State& state);
    void play(Preset preset,
              std::shared_ptr<const Instrument> instrument,
              std::unique_ptr<Player> player,
              const std::function<void()>& loadValues);
    void handOver(std::unique_ptr<Player> player, const std::function<void()>& loadValues);
    void tuneTo(ScalaTuning wanted, const KeyTuning& keys);
    void recordTuning(const std::string& step, const ScalaTuning& before, const ScalaTuning& after);
    Result<std::unique_ptr<Player>> newPlayer(const std::shared_ptr<const Instrument>& instrument,
                                              const Preset& preset,
                                              const ParameterValues& values) const;
    Result<std::unique_ptr<Player>> playerForLevel(const Preset& preset,
                                                   const ParameterValues& values) const;
    void goOn(std::unique_ptr<Player> player, const std::function<void()>& loadValues);
    bool
    changeModes(std::size_t object,
                const std::function<bool(const std::string& key, std::size_t modeCount)>& change);
    void sendSilences();

    // In ProcessorForWorkshop.cpp; for the message thread.
    /// The sound that plays and the number of its load. A sound made from it is played only if no
    /// other thread has loaded something since.
    struct Loaded {
        Sound sound;
        int number = 0;
    };
    Loaded loaded() const;
    Sound soundNow() const;
    void countHostLoad();
    double rateHz() const;
    void beginImport(int number);
    bool followsImportSettings() const { return importLoads == loads && workshop.hasMesh(); }
    void followWorkshop();
    std::shared_ptr<const ModalObject> foreignObject() const;
    ImportSettings settingsInForce() const;
    void playProduct(const ObjectWorkshop::Product& product);
    void renewHistory(const ModalObject& preview,
                      const KeyMap& wholeMap,
                      const std::shared_ptr<const Instrument>& whole);
    void playMapped(const Loaded& now, const KeyMap& map, const std::string& step);
    ParameterValues asLoudAs(const Sound& before,
                             const Preset& preset,
                             const std::shared_ptr<const Instrument>& built,
                             ParameterValues values) const;
    std::optional<int> playInstead(const Loaded& now,
                                   const Preset& preset,
                                   const std::shared_ptr<const Instrument>& built,
                                   const ParameterValues& values);

    static constexpr std::int64_t noRequest = -1, programsOfMidi = 128;
    /// The values when MIDI asked for a program, and how often each had been set. Values set later
    /// belong to the program.
    struct MovesAtRequest {
        std::int64_t request = noRequest;
        std::uint32_t soundChanges = 0; ///< if unchanged, no other sound was loaded since
        HostParameters::Moves moves{};
        ParameterValues values;
    };
    void forgetEvents() noexcept;
    void followControllers(const juce::MidiBuffer& midi) noexcept;
    void requestProgram(int program) noexcept;
    void followTransport(Player& player, int blockSamples) noexcept;
    void followGivenBends(Player& player) noexcept;
    bool isVst3() const noexcept { return wrapperType == wrapperType_VST3; }
    std::span<float* const> channelsFrom(juce::AudioBuffer<float>& buffer, int start) noexcept;
    void report(std::span<float* const> channels, int count) noexcept;

    HostParameters parameters;
    // Owned by the message thread.
    std::vector<Material> userMaterials;
    SoundPicture picture;
    StageCapture capture; ///< the audio thread feeds it
    std::uint32_t callbacksSeen = 0, lastCallbackMilliseconds = 0;
    int asksUnanswered = 0;
    std::int64_t notFiniteShown = 0;
    std::optional<std::size_t> watched; ///< index of the object that the window watches
    int watchedInstrument = 0;
    ObjectWorkshop workshop;
    ImportSettings importSettings; ///< settings given for opened files
    int importLoads = -1;          ///< load that the workshop's job began from or led to
    bool importFailureShown = true;
    std::weak_ptr<const ModalObject> imported; ///< the last product that played
    bool importedIsPreview = false;
    std::weak_ptr<const ModalObject>
        settingsGivenFor; ///< foreign object when the settings were given

    // Owned by the message side, under soundMutex.
    mutable std::mutex soundMutex;
    Preset loadedPreset;
    ModeSet modesHeardAlone;
    ScalaTuning scala; ///< from files
    KeyTuning ownKeys; ///< computed from `scala`
    std::shared_ptr<const Instrument> instrument;
    std::shared_ptr<const MissingObjects> missing; ///< a stand-in plays for these; or null
    std::string presetId;                          ///< on the shelf, or empty
    std::uint64_t presetContent = 0;               ///< see Sound
    ParameterValues storedParameters;              ///< values of that preset
    std::optional<Sound> soundBeforePrograms; ///< sound before MIDI's programs, not recorded yet
    std::string lastError;
    double preparedRateHz = 0;                ///< 0 until prepared
    std::int64_t answeredRequest = noRequest; ///< last request whose player was handed over
    MovesAtRequest atLastRequest;

    // Shared between threads.
    Handoff<Player> handoff;
    NoteQueue editorNotes;
    SurfaceHand hand;
    ModeSilencer silencer;
    Tuner tuner;
    SoundMonitor monitor;
    MidiLearn controllers;
    std::atomic<int> loads{0}, loadsByHost{0};
    std::atomic<std::uint32_t> callbacks{0}; ///< one more for each `prepareToPlay`
    std::atomic<bool> isPrepared{false};     ///< set by the first `prepareToPlay`
    std::atomic<bool> resetRequested{false};
    std::atomic<bool> stagePaused{false};
    std::atomic<bool> stageResetRequested{false};
    std::atomic<bool> forgetsGivenBends{false}; ///< until the player has forgotten them
    /// The last program that MIDI asked for, until its player is handed over or it is refused. The
    /// upper bits hold a serial number, as MIDI may ask for the same program again. A player's
    /// label is the last request answered when it was handed over. A refused request has no player.
    std::atomic<std::int64_t> requestedProgram{noRequest}, refusedRequest{noRequest};
    LatestValue<MovesAtRequest> movesAtRequest{{}}; ///< read under soundMutex
    std::atomic<int> soundToTell{0};                ///< further reports of the sound to the host
    int movedToTell = 0; ///< further reports of values that moved meanwhile
    /// States being restored; meanwhile JUCE's VST3 reports nothing to the host.
    std::atomic<int> statesComing{0};
    std::atomic<int> programIndex{-1};
    SharedFigures<DecayBounds> ownDecays, allDecays; ///< of the loaded keys (RingingKeys)
    std::atomic<bool> playedResizedKeys{false};      ///< by the current player
    /// [semitones] How far any key may sound below equal temperament: by the instance's own tuning
    /// alone, and by tunings and wheels in the player.
    std::atomic<double> semitonesBelowTuned{0}, semitonesBelowPlayed{0};
    std::atomic<double> tempo{0};        ///< last reported by the host, or 0
    std::atomic<double> stageSeconds{0}; ///< time that bodies move after a note
    std::atomic<int> modulationWheel{HeldContacts::controllerAtRest}; ///< last position
    std::atomic<std::int64_t> modesMixed{0};
    std::atomic<std::int64_t> lateEvents{0};
    std::atomic<std::int64_t> notFinite{0};
    std::atomic<float> peak{0};
    /// Odd while values and their player are being handed over.
    std::atomic<std::uint32_t> soundChanges{0};

    // Owned by the audio thread.
    BlockPieces pieces;
    PlayerCrossfade sound{handoff};
    PendingKeys pendingKeys;
    HostTransport transport;
    std::int64_t programRequests = 0;
    MovesAtRequest atProgramChange;          ///< values at the last program change
    std::int64_t awaitedRequest = noRequest; ///< the last request
    ParameterValues playedValues;            ///< values of this callback
    OutputStage output;
    std::array<float, BlockPieces::maximumSamples> left{}, right{};
    std::array<float*, 2> channelPointers{};

    // Owned by the message thread.
    std::array<int, parameterCount> openGestures{}; ///< of each parameter
    SoundHistory history{*this};
    PresetCollection shelf{*this, history, userSettingsFolder()};

    std::optional<GuardedTimer> looks;
};

} // namespace idiophone
