#include "Plugin/Processor.h"

#include "Editor/EditorWindow.h"
#include "Editor/Utf8.h"
#include "Instrument/FactoryContent.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

int presetCount() {
    return static_cast<int>(factoryPresets().size());
}

} // namespace

/// An instrument's side chain and further outputs are closed at first. An LV2 has none, because its
/// hosts connect every port of a plugin.
juce::AudioProcessor::BusesProperties Processor::busesOf(PluginKind kindOfPlugin) {
    const auto stereo = juce::AudioChannelSet::stereo();
    const auto outputs = BusesProperties().withOutput("Output", stereo, true);
    if (kindOfPlugin == PluginKind::resonator)
        return outputs.withInput("Input", stereo, true);
    if (juce::PluginHostType::getPluginLoadedAs() != wrapperType_VST3)
        return outputs;
    auto buses = outputs.withInput("Side chain", stereo, false);
    for (std::size_t number = 2; number <= maximumOutputs; ++number)
        buses.addBus(false, "Out " + juce::String(static_cast<int>(number)), stereo, false);
    return buses;
}

Processor::Processor(PluginKind kindOfPlugin, HostParameters::MakeParameter make)
    : AudioProcessor(busesOf(kindOfPlugin)), kind(kindOfPlugin),
      shared(
          *this, presetCount(), [this] { pollSoon(); }, make),
      engine(shared.parameters, shared.messages, shared.programs, shared.report), session(shared),
      window(shared, session), host(shared, session, window.tuning) {
    shared.reporter.vst3().hasMainInput = kind == PluginKind::resonator;
    setCurrentProgram(0);
    shared.reporter.forget(); // the host has not asked yet
    polls.emplace(pollMilliseconds, [this] { poll(); });
}

void Processor::processBlock(juce::AudioBuffer<float>& buffer, juce::MidiBuffer& midi) {
    const juce::ScopedNoDenormals noDenormals;
    if (!engine.isPrepared()) { // some hosts process unprepared plugins
        buffer.clear();
        midi.clear();
        return;
    }
    engine.process({.samples = buffer,
                    .inputs = getTotalNumInputChannels(),
                    .outputs = outputChannels(),
                    .isEffect = kind == PluginKind::resonator},
                   midi, getPlayHead(), isNonRealtime());
    if (isNonRealtime())
        host.followRequest();
}

void Processor::poll() {
    window.poll();
    if (!isNonRealtime()) {
        host.followRequest(); // offline the callback does this
        shared.reporter.poll(shared.messages.controllers);
    }
    session.poll();
}

bool Processor::isBusesLayoutSupported(const BusesLayout& layouts) const {
    const auto isMonoOrStereo = [](const juce::AudioChannelSet& set) {
        return set == juce::AudioChannelSet::mono() || set == juce::AudioChannelSet::stereo();
    };
    const auto mayComeIn = [&](const juce::AudioChannelSet& set) {
        return isMonoOrStereo(set) || (set.isDisabled() && kind == PluginKind::instrument);
    };
    return layouts.inputBuses.size() == getBusCount(true) &&
           std::ranges::all_of(layouts.inputBuses, mayComeIn) &&
           layouts.outputBuses.size() == getBusCount(false) &&
           isMonoOrStereo(layouts.outputBuses.getReference(0)) &&
           std::all_of(layouts.outputBuses.begin() + 1, layouts.outputBuses.end(),
                       [](const juce::AudioChannelSet& set) {
                           return set.isDisabled() || set == juce::AudioChannelSet::stereo();
                       });
}

std::array<int, maximumOutputs> Processor::outputChannels() const noexcept {
    std::array<int, maximumOutputs> channels{};
    for (int bus = 0; bus < getBusCount(false); ++bus)
        channels[static_cast<std::size_t>(bus)] = getChannelCountOfBus(false, bus);
    return channels;
}

void Processor::prepareToPlay(double sampleRateHz, int) {
    const double rateHz = std::isfinite(sampleRateHz) && sampleRateHz > 0 ? sampleRateHz : 44100;
    OutputSet outputs;
    for (std::size_t bus = 0; bus < maximumOutputs; ++bus)
        outputs[bus] = outputChannels()[bus] > 0;
    session.prepare(rateHz, [&](std::unique_ptr<Player> player) {
        engine.prepare(rateHz, std::move(player), outputs);
    });
}

void Processor::releaseResources() {
    const auto held = session.lock();
    shared.messages.players.collect();
}

/// Forgets the sent values only on a change, because some wrappers call this for every block.
/// Offline, no controller value is sent to the host, so no value from the host is an echo.
void Processor::setNonRealtime(bool isOffline) noexcept {
    if (isOffline != isNonRealtime())
        shared.parameters.forgetLastSent();
    AudioProcessor::setNonRealtime(isOffline);
}

juce::AudioProcessorParameter* Processor::getBypassParameter() const {
    return &shared.parameters[ParameterId::bypass];
}

double Processor::getTailLengthSeconds() const {
    return shared.tail.seconds(shared.parameters.modulatedValues(), shared.report);
}

// A VST3 host cannot choose the current program again. So its last program stands for any sound
// that is not a factory preset.

int Processor::getNumPrograms() {
    return presetCount() + (isVst3() ? 1 : 0);
}

int Processor::getCurrentProgram() {
    const int index = session.program();
    return index >= 0 ? index : isVst3() ? presetCount() : 0;
}

const juce::String Processor::getProgramName(int index) {
    if (index < 0 || index >= getNumPrograms())
        return {};
    if (index < presetCount())
        return fromUtf8(factoryPresets()[static_cast<std::size_t>(index)].name);
    return "Own sound";
}

void Processor::getStateInformation(juce::MemoryBlock& destination) {
    const auto bytes = host.save();
    destination.replaceAll(bytes.data(), bytes.size());
}

void Processor::setStateInformation(const void* bytes, int byteCount) {
    host.restore(
        {static_cast<const char*>(bytes), static_cast<std::size_t>(std::max(byteCount, 0))});
}

juce::AudioProcessorEditor* Processor::createEditor() {
    return new EditorWindow(*this, window.view);
}

} // namespace idiophone
