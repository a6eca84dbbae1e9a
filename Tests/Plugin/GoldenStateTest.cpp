// Projects of released versions sound as they did: states saved by each of them, with renders of
// what they sounded like then (Golden/VERSION/NAME.state and .wav), and all names and numbers by
// which projects, presets and hosts know things (names.txt).
#include "Instrument/FactoryContent.h"
#include "Scene/FactoryScenes.h"
#include "Support/SimdTargets.h"
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <juce_audio_formats/juce_audio_formats.h>
#include <set>
#include <sstream>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double rateHz = 22050;
constexpr int samples = 22050, blockSize = 256, depthBits = 32; // float
constexpr double farthestDb = -110;                             // of the peak

const std::filesystem::path goldenFolder =
    std::filesystem::path(IDIOPHONE_SOURCE_DIR) / "Tests/Plugin/Golden";

juce::MidiBuffer phrase(const Processor& processor) {
    juce::MidiBuffer midi;
    const auto keys = processor.keyRange();
    const int span = keys.highest - keys.lowest;
    const auto add = [&](const juce::MidiMessage& message, int stamp) {
        midi.addEvent(message, stamp);
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
    return midi;
}

juce::AudioBuffer<float> played(const std::string& state) {
    Processor processor;
    restoreBytes(processor, state);
    REQUIRE_FALSE(processor.takeStatus().isError);
    processor.prepareToPlay(rateHz, blockSize);
    const auto midi = phrase(processor);
    juce::AudioBuffer<float> sound(2, samples);
    for (int start = 0; start < samples; start += blockSize) {
        const int count = std::min(blockSize, samples - start);
        juce::AudioBuffer<float> block(sound.getArrayOfWritePointers(), 2, start, count);
        juce::MidiBuffer events;
        events.addEvents(midi, start, count, -start);
        processor.processBlock(block, events);
    }
    return sound;
}

std::string bytesOf(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

juce::AudioBuffer<float> readWave(const std::filesystem::path& file) {
    const std::unique_ptr<juce::AudioFormatReader> reader(juce::WavAudioFormat().createReaderFor(
        new juce::FileInputStream(juce::File(file.string())), true));
    REQUIRE(reader != nullptr);
    REQUIRE(reader->sampleRate == rateHz);
    juce::AudioBuffer<float> sound(2, static_cast<int>(reader->lengthInSamples));
    reader->read(&sound, 0, sound.getNumSamples(), 0, true, true);
    return sound;
}

void writeWave(const std::filesystem::path& file, const juce::AudioBuffer<float>& sound) {
    std::filesystem::remove(file);
    const std::unique_ptr<juce::AudioFormatWriter> writer(juce::WavAudioFormat().createWriterFor(
        new juce::FileOutputStream(juce::File(file.string())), rateHz, 2, depthBits, {}, 0));
    REQUIRE(writer != nullptr);
    REQUIRE(writer->writeFromAudioSampleBuffer(sound, 0, sound.getNumSamples()));
}

double differenceDb(const juce::AudioBuffer<float>& a, const juce::AudioBuffer<float>& b) {
    REQUIRE(a.getNumSamples() == b.getNumSamples());
    double most = 0;
    for (int channel = 0; channel < 2; ++channel)
        for (int i = 0; i < a.getNumSamples(); ++i)
            most = std::max(most, std::abs(static_cast<double>(a.getSample(channel, i)) -
                                           b.getSample(channel, i)));
    return 20 * std::log10(most / b.getMagnitude(0, b.getNumSamples()));
}

/// What is for ever: a line for each.
std::vector<std::string> publishedNames() {
    std::vector<std::string> lines;
    const auto add = [&](const auto&... words) {
        std::ostringstream line;
        ((line << words << ' '), ...);
        lines.push_back(line.str().substr(0, line.str().size() - 1));
    };
    Processor processor;
    const auto& parameters = processor.getParameters();
    for (int i = 0; i < parameters.size(); ++i) {
        const auto* hosted = dynamic_cast<juce::HostedAudioProcessorParameter*>(parameters[i]);
        REQUIRE(hosted != nullptr);
        const auto id = hosted->getParameterID().toStdString();
        add("parameter", i, id, "since", hosted->getVersionHint());
        REQUIRE(findParameter(id) != nullptr);
        const auto choices = choiceNames(findParameter(id)->parameter);
        for (std::size_t choice = 0; choice < choices.size(); ++choice)
            add(id, choice, choices[choice]);
    }
    for (int i = 0; i < processor.getNumPrograms(); ++i)
        add("program", i, processor.getProgramName(i));
    for (const auto& scene : factoryScenes())
        add("scene", scene.name);
    const auto objects = std::filesystem::path(IDIOPHONE_SOURCE_DIR) / "Resources/Objects";
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(objects))
        if (const auto name = entry.path().stem().string(); factoryObject(name))
            names.insert(name);
    for (const auto& name : names)
        add("object", name);
    return lines;
}

} // namespace

TEST_CASE("States of every released version sound as they did, on every SIMD target") {
    int found = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(goldenFolder)) {
        if (entry.path().extension() != ".state")
            continue;
        ++found;
        const auto golden = readWave(std::filesystem::path(entry.path()).replace_extension(".wav"));
        REQUIRE(golden.getMagnitude(0, samples) > 1e-3f);
        const auto state = bytesOf(entry.path());
        for (const auto target : targetsHere()) {
            const TargetInTurn turn(target);
            INFO(entry.path() << " on " << hwy::TargetName(target));
            CHECK(differenceDb(played(state), golden) < farthestDb);
        }
    }
    CHECK(found >= 6);
}

TEST_CASE("Whatever a released version named and numbered is there under its name and number") {
    const auto now = publishedNames();
    const std::set<std::string> present(now.begin(), now.end());
    int found = 0;
    for (const auto& version : std::filesystem::directory_iterator(goldenFolder)) {
        INFO(version.path());
        std::ifstream file(version.path() / "names.txt");
        REQUIRE(file);
        for (std::string line; std::getline(file, line); ++found) {
            INFO(line);
            CHECK(present.contains(line));
        }
    }
    CHECK(found >= 300);
}

namespace {

std::filesystem::path folderOfThisVersion() {
    if (std::getenv("IDIOPHONE_MAKE_GOLDEN") == nullptr)
        SKIP("IDIOPHONE_MAKE_GOLDEN is not set");
    Processor processor;
    const auto folder = goldenFolder / parseState(saved(processor))->engineVersion;
    std::filesystem::create_directories(folder);
    return folder;
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

std::string tunedObjects() {
    auto state = testState("golden");
    state.tuning.scale = {.name = "seven.scl",
                          .text = "Seven equal steps\n7\n171.43\n342.86\n514.29\n685.71\n857.14\n"
                                  "1028.57\n2/1\n"};
    state.parameters.set(ParameterId::mpe, 1);
    state.parameters.set(ParameterId::concertPitch, 415);
    return encodeState(state);
}

} // namespace

// For a release, once its version is set: `IDIOPHONE_MAKE_GOLDEN=1 test_plugin "[make-golden]"`.
// Never for an older version, and so never by a pattern of names that happens to fit.
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
        {"tuned-objects", tunedObjects()}};
    for (const auto& [name, state] : states) {
        std::ofstream(folder / (std::string(name) + ".state"), std::ios::binary) << state;
        writeWave(folder / (std::string(name) + ".wav"), played(state));
    }
}

TEST_CASE("Record the names of this version", "[.][make-golden]") {
    std::ofstream file(folderOfThisVersion() / "names.txt", std::ios::binary);
    for (const auto& line : publishedNames())
        file << line << '\n';
}
