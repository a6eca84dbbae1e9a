// Implements the plugin that a host drives: passes JUCE's calls on to the engine and the sessions.
#pragma once

#include "Plugin/AudioEngine.h"
#include "Plugin/GuardedTimer.h"
#include "Plugin/HostSession.h"
#include "Plugin/WindowSession.h"

#include <juce_audio_processors/juce_audio_processors.h>
#include <optional>

namespace idiophone {

/// The plugins that are built from this processor.
enum class PluginKind {
    instrument, ///< plays notes; a VST3 also has a side-chain input and further outputs
    resonator   ///< an effect: what comes in presses on an object, and notes may strike it
};

/// Threads: `processBlock` runs the engine, which neither allocates, locks nor calls the system.
/// Everything that changes the sound (states, programs, `prepareToPlay`) may come from any other
/// thread and takes the session's lock. A program that MIDI asks for is loaded by a message-thread
/// timer some 50 ms later. In an offline render the callback loads it between two blocks.
class Processor : public juce::AudioProcessor {
public:
    /// `make` makes each of the parameters.
    explicit Processor(PluginKind kind = PluginKind::instrument,
                       HostParameters::MakeParameter make = HostParameters::makePlain);

    const juce::String getName() const override {
        return kind == PluginKind::resonator ? "Idiophone Resonator" : "Idiophone";
    }
    bool acceptsMidi() const override { return true; }
    bool producesMidi() const override { return false; }
    bool supportsMPE() const override { return true; }

    bool isBusesLayoutSupported(const BusesLayout& layouts) const override;
    void prepareToPlay(double sampleRateHz, int maximumBlockSize) override;
    void releaseResources() override;
    void reset() override { shared.messages.reset = true; }
    void setNonRealtime(bool isOffline) noexcept override;
    void processBlock(juce::AudioBuffer<float>& buffer, juce::MidiBuffer& midi) override;
    using AudioProcessor::processBlock;

    juce::AudioProcessorParameter* getBypassParameter() const override;
    double getTailLengthSeconds() const override;
    juce::VST3ClientExtensions* getVST3ClientExtensions() override {
        return &shared.reporter.vst3();
    }

    /// Returns the number of factory presets. A VST3 has one more program, for any other sound.
    int getNumPrograms() override;
    int getCurrentProgram() override;
    void setCurrentProgram(int index) override { host.chooseProgram(index); }
    const juce::String getProgramName(int index) override;
    void changeProgramName(int, const juce::String&) override {} // factory presets keep their names

    void getStateInformation(juce::MemoryBlock& destination) override;
    void setStateInformation(const void* bytes, int byteCount) override;

    bool hasEditor() const override { return true; }
    juce::AudioProcessorEditor* createEditor() override;

    /// The parts, for the window and for tests; each names its threads.
    ProcessorView& view() { return window.view; }
    SoundSession& soundSession() { return session; }
    WindowSession& windowSession() { return window; }
    HostParameters& parameters() { return shared.parameters; }
    const EngineReport& engineReport() const { return shared.report; }

    /// [message thread] Polls the engine and the workshop. A timer calls it every
    /// `pollMilliseconds`.
    void poll();
    static constexpr int pollMilliseconds = 50;
    /// [any thread, between two callbacks] See PlayedStage::waitForSimulation.
    void waitForSimulation() noexcept { engine.waitForSimulation(); }

protected:
    /// [audio thread] For formats that move single notes.
    AudioEngine& audioEngine() noexcept { return engine; }

private:
    bool isVst3() const noexcept { return wrapperType == wrapperType_VST3; }

    void pollSoon() {
        if (polls)
            polls->callSoon();
    }
    static BusesProperties busesOf(PluginKind kindOfPlugin);
    std::array<int, maximumOutputs> outputChannels() const noexcept;

    PluginKind kind;

    SharedParts shared;
    AudioEngine engine;
    SoundSession session;
    WindowSession window;
    HostSession host;
    std::optional<GuardedTimer> polls; ///< last: ends before everything that it polls
};

} // namespace idiophone
