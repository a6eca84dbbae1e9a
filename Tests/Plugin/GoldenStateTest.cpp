// Projects of released versions sound as they did: states saved by each of them, with renders of
// what they sounded like then (Golden/VERSION/NAME.state and .wav, and of some NAME-48k.wav or
// NAME-5s.wav).
#include "Plugin/GoldenFolder.h"
#include "Support/SimdTargets.h"

#include "Instrument/FactoryContent.h"

#include <cmath>
#include <functional>
#include <juce_audio_formats/juce_audio_formats.h>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr int depthBits = 32;       // float
constexpr double farthestDb = -110; // of the peak

class Tempo final : public juce::AudioPlayHead {
public:
    juce::Optional<PositionInfo> getPosition() const override {
        PositionInfo position;
        position.setBpm(150);
        return position;
    }
};

constexpr int phraseSamples = 22050;
void addPhrase(juce::MidiBuffer& midi, const Processor& processor, int start) {
    const auto keys = processor.keyRange();
    const int span = keys.highest - keys.lowest;
    const auto add = [&](const juce::MidiMessage& message, int stamp) {
        midi.addEvent(message, start + stamp);
    };
    add(juce::MidiMessage::controllerEvent(1, 1, 100), 0);
    for (int i = 0; i < 8; ++i) {
        const int note = keys.lowest + span * (i * 5 % 8) / 7, stamp = 37 + 2203 * i;
        const int channel = i % 3 + 1;
        add(juce::MidiMessage::noteOn(channel, note, static_cast<juce::uint8>(30 + 12 * i)), stamp);
        add(juce::MidiMessage::channelPressureChange(channel, 20 + 10 * i), stamp + 900);
        add(juce::MidiMessage::controllerEvent(channel, 74, 40 + 8 * i), stamp + 1000);
        add(juce::MidiMessage::pitchWheel(channel, 8192 + 200 * i), stamp + 1500);
        add(juce::MidiMessage::noteOff(channel, note), stamp + 2900);
    }
    add(juce::MidiMessage::controllerEvent(1, 64, 127), 9000);
    add(juce::MidiMessage::controllerEvent(1, 64, 0), 15000);
}

/// The phrase, and again from time to time.
juce::MidiBuffer music(const Processor& processor, int samples) {
    juce::MidiBuffer midi;
    for (int start = 0; start + phraseSamples <= samples; start += 60000)
        addPhrase(midi, processor, start);
    return midi;
}

juce::AudioBuffer<float> played(const std::string& state,
                                const GoldenTake& take = goldenTakes.front()) {
    Tempo tempo;
    Processor processor;
    processor.setPlayHead(&tempo);
    processor.setNonRealtime(true); // so that scenes are never late
    restoreBytes(processor, state);
    REQUIRE_FALSE(processor.takeStatus().isError);
    processor.prepareToPlay(take.rateHz, goldenBlockSize);
    const auto midi = music(processor, take.samples);
    juce::AudioBuffer<float> kept(2, take.samples), block(2, goldenBlockSize);
    int keptSamples = 0;
    for (int start = 0; start < take.samples; start += goldenBlockSize) {
        const int count = std::min(goldenBlockSize, take.samples - start);
        block.setSize(2, count, false, false, true);
        juce::MidiBuffer events;
        events.addEvents(midi, start, count, -start);
        processor.processBlock(block, events);
        if (start / goldenBlockSize % take.keptOf < take.keptOf - 1)
            continue;
        for (int channel = 0; channel < 2; ++channel)
            kept.copyFrom(channel, keptSamples, block, channel, 0, count);
        keptSamples += count;
    }
    kept.setSize(2, keptSamples, true);
    return kept;
}

juce::AudioBuffer<float> readWave(const std::filesystem::path& file, double rateHz) {
    const std::unique_ptr<juce::AudioFormatReader> reader(juce::WavAudioFormat().createReaderFor(
        new juce::FileInputStream(juce::File(file.string())), true));
    REQUIRE(reader != nullptr);
    REQUIRE(reader->sampleRate == rateHz);
    REQUIRE(reader->numChannels == 2);
    juce::AudioBuffer<float> sound(2, static_cast<int>(reader->lengthInSamples));
    reader->read(&sound, 0, sound.getNumSamples(), 0, true, true);
    return sound;
}

void writeWave(const std::filesystem::path& file,
               const juce::AudioBuffer<float>& sound,
               double rateHz) {
    std::filesystem::remove(file);
    const std::unique_ptr<juce::AudioFormatWriter> writer(juce::WavAudioFormat().createWriterFor(
        new juce::FileOutputStream(juce::File(file.string())), rateHz, 2, depthBits, {}, 0));
    REQUIRE(writer != nullptr);
    REQUIRE(writer->writeFromAudioSampleBuffer(sound, 0, sound.getNumSamples()));
}

bool allFinite(const juce::AudioBuffer<float>& sound) {
    for (int channel = 0; channel < sound.getNumChannels(); ++channel)
        for (int i = 0; i < sound.getNumSamples(); ++i)
            if (!std::isfinite(sound.getSample(channel, i)))
                return false;
    return true;
}

/// Of the larger channel's peak.
double differenceDb(const juce::AudioBuffer<float>& a, const juce::AudioBuffer<float>& b) {
    REQUIRE((a.getNumChannels() == 2 && b.getNumChannels() == 2));
    REQUIRE(a.getNumSamples() == b.getNumSamples());
    REQUIRE((allFinite(a) && allFinite(b))); // nothing is larger than NaN
    double most = 0;
    for (int channel = 0; channel < 2; ++channel)
        for (int i = 0; i < a.getNumSamples(); ++i)
            most = std::max(most, std::abs(static_cast<double>(a.getSample(channel, i)) -
                                           b.getSample(channel, i)));
    return 20 * std::log10(most / b.getMagnitude(0, b.getNumSamples()));
}

/// The state of a factory preset with some parameters changed.
std::string changed(const char* preset, std::initializer_list<std::pair<const char*, double>> to) {
    Processor processor;
    const auto presets = factoryPresets();
    for (std::size_t i = 0; i < presets.size(); ++i)
        if (presets[i].name == preset)
            processor.setCurrentProgram(static_cast<int>(i));
    REQUIRE(processor.loadedLabel().name == preset);
    for (const auto& [id, value] : to) {
        REQUIRE(findParameter(id) != nullptr);
        processor.changeParameter(findParameter(id)->parameter, value);
    }
    return saved(processor);
}

} // namespace

TEST_CASE("States of every released version sound as they did, on every SIMD target") {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(goldenFolder)) {
        if (entry.path().extension() != ".state")
            continue;
        const auto state = bytesOf(entry.path());
        for (const auto& take : goldenTakes) {
            const auto file = waveOf(entry.path(), take);
            if (take.ending != goldenTakes.front().ending && !std::filesystem::exists(file))
                continue; // only of some
            const auto golden = readWave(file, take.rateHz);
            for (int channel = 0; channel < 2; ++channel)
                REQUIRE(golden.getMagnitude(channel, 0, golden.getNumSamples()) > 1e-3f);
            for (const auto target : targetsHere()) {
                const TargetInTurn turn(target);
                INFO(file << " on " << hwy::TargetName(target));
                CHECK(differenceDb(played(state, take), golden) < farthestDb);
            }
        }
    }
}

TEST_CASE("A state plays the preset that it holds, whatever the factory's of that name becomes") {
    const auto factory = changed("Scraped Plate", {});
    const auto asFactory = played(factory);
    const auto checkHeard = [&](const std::function<void(State&)>& change) {
        auto state = *parseState(factory);
        change(state);
        const auto sound = played(encodeState(state));
        CHECK(differenceDb(sound, asFactory) > -60);
        Processor processor;
        restore(processor, state);
        CHECK(parseState(saved(processor))->preset == state.preset);
    };
    checkHeard([](State& state) { state.preset.keyMap.strikePath = {{0, 0, 0}}; });
    checkHeard([](State& state) { state.preset.surface.resonFrequencyHz *= 2; });
    checkHeard([](State& state) { ++state.preset.seed; });
    checkHeard([](State& state) { state.parameters.set(ParameterId::contactForce, 20); });
}

namespace {

std::string tunedObjects() {
    auto state = testState("golden");
    state.tuning.scale = {.name = "seven.scl",
                          .text = "Seven equal steps\n7\n171.43\n342.86\n514.29\n685.71\n857.14\n"
                                  "1028.57\n2/1\n"};
    state.parameters.set(ParameterId::mpe, 1);
    state.parameters.set(ParameterId::concertPitch, 415);
    return encodeState(state);
}

/// Kirnberger's third, on a white-key mapping, beside bends and MPE.
std::string bentBells() {
    auto state = *parseState(changed("Tubular Bells", {{"mpe", 1},
                                                       {"mpe_bend_range", 24},
                                                       {"bend_range", 7},
                                                       {"tune", -31},
                                                       {"contact", 0},
                                                       {"mallet", 3}}));
    state.tuning.scale = {.name = "kirnberger3.scl",
                          .text = "Kirnberger III\n12\n90.225\n193.157\n294.135\n386.314\n"
                                  "498.045\n590.224\n696.578\n792.18\n889.735\n996.09\n"
                                  "1088.269\n2/1\n"};
    state.tuning.mapping = {.name = "from-d.kbm",
                            .text = "12\n0\n127\n62\n69\n437\n12\n0\n1\n2\n3\n4\n5\n6\n"
                                    "7\n8\n9\n10\n11\n"};
    return encodeState(state);
}

std::string mutedGlassWok() {
    auto state = *parseState(changed("Wok", {{"material", 6}, {"thickness", 60}, {"let_ring", 1}}));
    for (const int mode : {0, 1, 4, 9})
        REQUIRE(state.preset.mutedModes.set("all", mode, true));
    return encodeState(state);
}

/// Of all states the first take; what scrapes, what chatters in high modes and a scene at 48 kHz;
/// a room for long.
bool isMade(const std::string& state, const GoldenTake& take) {
    const std::string ending = take.ending;
    if (ending == "-48k.wav")
        return state == "scraped-plate" || state == "glass-handbell" || state == "dice";
    return ending == ".wav" || state == "padauk-in-a-room";
}

} // namespace

// For a release, once its version is set: `IDIOPHONE_MAKE_GOLDEN=1 test_plugin "[make-golden]"`.
// Never for an older version, and so never by a pattern of names that happens to fit. What is there
// already stays.
TEST_CASE("Make the golden states of this version", "[.][make-golden]") {
    const auto folder = folderOfThisVersion();
    const std::pair<const char*, std::string> states[] = {
        {"xylophone", changed("Rosewood Xylophone", {})},
        {"vibraphone", changed("Vibraphone", {{"motor_depth", 80}, {"width", 150}})},
        {"glass-handbell",
         changed("Handbell", {{"material", 10}, {"size", 0.8}, {"chatter", 60}, {"mallet", 6}})},
        {"scraped-plate", changed("Scraped Plate", {{"force", 20}, {"roughness", 2}})},
        {"thin-marimba", changed("Marimba", {{"material", customMaterial},
                                             {"young", 3},
                                             {"loss_factor", 0.01},
                                             {"tau", 5},
                                             {"budget", 64},
                                             {"compression", 2},
                                             {"let_ring", 0},
                                             {"release", 0.3},
                                             {"match_loudness", 1}})},
        {"tuned-objects", tunedObjects()},
        {"rolled-table", changed("Wooden Table", {{"contact", rollContact},
                                                  {"force", 50},
                                                  {"roughness", 3},
                                                  {"roll_coupling", 40},
                                                  {"level", 20}})},
        // Loud before its level: juce::Reverb rounds at -140 dB of full scale.
        {"padauk-in-a-room",
         changed("Padauk Xylophone", {{"width", 150}, {"room", 60}, {"room_decay", 1.5}})},
        {"synced-vibraphone",
         changed("Vibraphone", {{"modal_pulse", 1}, {"motor_sync", 4}, {"motor_depth", 100}})},
        {"muted-glass-wok", mutedGlassWok()},
        {"bent-bells", bentBells()},
        {"dice", changed("Dice on Rosewood", {})}};
    for (const auto& [name, state] : states) {
        const auto file = folder / (std::string(name) + ".state");
        if (!std::filesystem::exists(file))
            std::ofstream(file, std::ios::binary) << state;
        for (const auto& take : goldenTakes) {
            const auto wave = waveOf(file, take);
            if (isMade(name, take) && !std::filesystem::exists(wave))
                writeWave(wave, played(bytesOf(file), take), take.rateHz);
        }
    }
}
