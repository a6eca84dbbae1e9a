// Scene presets in the plugin: their delay, equal sound in a bounce and in real time, and their
// states.
#include "Instrument/FactoryContent.h"
#include "Instrument/ObjectLibrary.h"
#include "Plugin/PresetObjects.h"
#include "Support/FullDisk.h"
#include "Support/TestFolder.h"
#include "Support/TestSound.h"
#include "Support/UserSettings.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinAbs;

namespace {

constexpr int rate = 48000;
const char* const dice = "Dice on Rosewood";

void choose(Processor& processor, const std::string& preset) {
    for (int program = 0; program < processor.getNumPrograms(); ++program)
        if (processor.getProgramName(program).toStdString() == preset)
            processor.setCurrentProgram(program);
    REQUIRE(processor.soundSession().loadedSound().preset.name == preset);
}

juce::MidiBuffer chord() {
    juce::MidiBuffer midi;
    midi.addEvent(juce::MidiMessage::noteOn(1, 72, static_cast<juce::uint8>(20)), 100);
    midi.addEvent(juce::MidiMessage::noteOn(1, 76, static_cast<juce::uint8>(120)), 100);
    midi.addEvent(juce::MidiMessage::noteOff(1, 72), 200);
    return midi;
}

HostSound bounce(const std::string& state, int blockSize) {
    Processor processor;
    processor.setNonRealtime(true);
    restoreBytes(processor, state);
    processor.prepareToPlay(rate, blockSize);
    const auto sound = render(processor, rate, blockSize, chord());
    CHECK(processor.view().status.takeStatus().lateEvents == 0);
    return sound;
}

const char* const mine =
    R"({"format": "idiophone-scene", "version": 1, "name": "Mine",
        "kinds": [{"name": "plate", "object": "plate", "fixed": true},
                  {"name": "die", "object": "die"}],
        "bodies": [{"kind": "plate"}, {"kind": "die", "at": [0, 0, 0.2]}]})";

/// Returns a state whose preset is a scene.
State songOf(const std::filesystem::path& scene) {
    auto state = testState();
    state.preset.keyMap = {
        .kind = KeyMapKind::scene, .lowestNote = 48, .highestNote = 72, .object = scene.string()};
    state.parameters.set(ParameterId::size, 1.5);
    state.objects.clear();
    return state;
}

std::size_t onset(const std::vector<float>& sound) {
    const float threshold = 0.01f * loudest(sound);
    const auto first =
        std::ranges::find_if(sound, [=](float x) { return std::abs(x) > threshold; });
    return static_cast<std::size_t>(first - sound.begin());
}

} // namespace

TEST_CASE("A scene preset sounds after the delay that the status reports") {
    Processor processor;
    choose(processor, dice);
    const double delay = processor.view().status.takeStatus().delaySeconds;
    CHECK(delay > 0.05);
    CHECK(processor.getTailLengthSeconds() > delay);
    const auto sound = bounce(saved(processor), 512);
    CHECK(loudest(sound) > 0);
    CHECK_THAT(static_cast<double>(onset(sound.left)) / rate,
               WithinAbs(100.0 / rate + delay, 0.002));
    choose(processor, factoryPresets().front().name);
    CHECK(processor.view().status.takeStatus().delaySeconds == 0);
}

TEST_CASE("A scene sounds the same from its state at any block size") {
    Processor processor;
    choose(processor, dice);
    const auto state = saved(processor);
    Processor other;
    restoreBytes(other, state);
    CHECK(saved(other) == state);
    CHECK(bounce(state, 512) == bounce(state, 100));
}

TEST_CASE("In real time a scene sounds as in a bounce if its worker is not late") {
    Processor processor;
    choose(processor, dice);
    const auto expected = bounce(saved(processor), 480);
    processor.prepareToPlay(rate, 480);
    auto sound = render(processor, 480, 480, chord());
    for (int rendered = 480; rendered < rate; rendered += 480) {
        processor.waitForSimulation();
        sound.append(render(processor, 480, 480, {}));
    }
    CHECK(processor.view().status.takeStatus().lateEvents == 0);
    CHECK(sound == expected);
}

TEST_CASE("The impacts of a scene are captured as notes and as impulses") {
    Processor processor;
    choose(processor, dice);
    processor.setNonRealtime(true);
    processor.prepareToPlay(rate, 480);
    CHECK_FALSE(processor.view().stage.hasCaptured());
    render(processor, rate, 480, chord());
    REQUIRE(processor.view().stage.hasCaptured());

    using enum StageView::CaptureKind;
    const auto midiFile = testFolder() / "capture.mid", list = testFolder() / "capture.jsonl";
    REQUIRE(processor.view().stage.writeCapture(midi, midiFile));
    juce::FileInputStream stream{juce::File(midiFile.string())};
    juce::MidiFile read;
    REQUIRE(read.readFrom(stream));
    read.convertTimestampTicksToSeconds();
    std::map<int, std::pair<double, int>> firstOfNote; // time in seconds and velocity
    int hardest = 0;
    for (const auto* event : *read.getTrack(0))
        if (event->message.isNoteOn()) {
            firstOfNote.try_emplace(event->message.getNoteNumber(), event->message.getTimeStamp(),
                                    event->message.getVelocity());
            hardest = std::max<int>(hardest, event->message.getVelocity());
        }
    // Both bars are struck within 2 ms of each other, the louder one harder.
    REQUIRE(firstOfNote.contains(72));
    REQUIRE(firstOfNote.contains(76));
    CHECK_THAT(firstOfNote[72].first, WithinAbs(firstOfNote[76].first, 0.002));
    CHECK(firstOfNote[76].second > firstOfNote[72].second);
    CHECK(hardest == 127);

    REQUIRE(processor.view().stage.writeCapture(impulses, list));
    std::ifstream lines(list);
    std::string line;
    REQUIRE(std::getline(lines, line));
    const auto first = nlohmann::json::parse(line);
    CHECK(first["time"] == 0);
    CHECK(first["impulse"].size() == 3);
    CHECK(factoryObject(first["object"].get<std::string>()));
    double before = 0;
    while (std::getline(lines, line)) {
        const double seconds = nlohmann::json::parse(line)["time"];
        CHECK(seconds >= before);
        before = seconds;
    }
    CHECK(before > 0.1);

#ifndef _WIN32
    const auto sizeOf = [](const auto& file) { return std::filesystem::file_size(file); };
    for (const auto& [kind, file] : {std::pair(midi, midiFile), std::pair(impulses, list)}) {
        const auto size = sizeOf(file);
        const bool written = [&] {
            const FullDisk disk(16);
            return processor.view().stage.writeCapture(kind, file);
        }();
        CHECK_FALSE(written);
        CHECK(processor.view().status.takeStatus().isError);
        CHECK(sizeOf(file) == size);
    }
#endif

    processor.view().stage.resetStage();
    CHECK_FALSE(processor.view().stage.hasCaptured());
    CHECK_FALSE(processor.view().stage.writeCapture(midi, midiFile));
    CHECK(processor.view().status.takeStatus().isError);
}

TEST_CASE(
    "A preset finds a scene file in its folder, and a project elsewhere opens the same file") {
    const auto folder = testFolder() / "scene-preset";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "mine.json") << mine;
    const auto built = buildPresetInstrument({.kind = KeyMapKind::scene, .object = "mine.json"},
                                             juce::File((folder / "preset.json").string()));
    REQUIRE(built);
    CHECK(built->notice.empty());
    CHECK(built->keyMap.object == (folder / "mine.json").string());
    auto state = testState();
    state.preset.keyMap = built->keyMap;
    state.objects.clear();
    Processor processor;
    restore(processor, state);
    CHECK_FALSE(processor.view().status.takeStatus().isError);
    CHECK(processor.view().stage.hasStage());
    CHECK(processor.view().stage.stageBodies().size() == 1);
    CHECK(buildPresetInstrument({.kind = KeyMapKind::scene, .object = "gone.json"},
                                juce::File((folder / "preset.json").string()))
              ->notice.find("gone.json") == 0);
}

TEST_CASE("A list of impulses names the files of the scene's objects") {
    const auto folder = testFolder() / "captured";
    std::filesystem::create_directories(folder);
    const auto die = factoryObject("die").value();
    std::ofstream(folder / "mine.modal", std::ios::binary)
        .write(reinterpret_cast<const char*>(die.data()), std::ssize(die));
    std::ofstream(folder / "mine.json")
        << R"({"format": "idiophone-scene", "version": 1, "name": "Mine", "seconds": 1,
               "kinds": [{"name": "plate", "object": "plate", "fixed": true},
                         {"name": "die", "object": "mine.modal"}],
               "bodies": [{"kind": "plate"}, {"kind": "die", "at": [0, 0, 0.02]}]})";
    auto state = testState();
    state.preset.keyMap = {.kind = KeyMapKind::scene, .object = (folder / "mine.json").string()};
    state.objects.clear();
    Processor processor;
    restore(processor, state);
    processor.setNonRealtime(true);
    processor.prepareToPlay(rate, 480);
    render(processor, rate / 2, 480, chord());
    const auto list = folder / "list.jsonl";
    REQUIRE(processor.view().stage.writeCapture(StageView::CaptureKind::impulses, list));
    std::set<std::string> objects;
    std::ifstream lines(list);
    for (std::string line; std::getline(lines, line);)
        objects.insert(nlohmann::json::parse(line)["object"].get<std::string>());
    CHECK(objects == std::set<std::string>{"mine.modal", "plate"});
}

TEST_CASE("A missing scene is replaced by a ring and plays once the file is back") {
    const auto file = testFolder() / "moved.json";
    std::filesystem::remove(file);
    auto state = songOf(file);
    REQUIRE(state.preset.mutedModes.set("die", 2, true));
    Processor first;
    restore(first, state);
    const auto status = first.view().status.takeStatus();
    CHECK(status.isError);
    CHECK(status.sentence.find(file.string() + " is missing") != std::string::npos);
    CHECK(first.soundSession().loadedSound().preset.name == "Test keyboard");
    CHECK(first.view().instrument.keyRange().lowest == 48);
    CHECK(first.view().parameters.value(ParameterId::size) == 1.5);
    const auto bytes = saved(first);
    CHECK(parseState(bytes)->preset == state.preset);

    std::ofstream(file) << mine;
    Processor second;
    restoreBytes(second, bytes);
    CHECK_FALSE(second.view().status.takeStatus().isError);
    CHECK(second.view().stage.hasStage());
    CHECK(saved(second) == bytes);
}

TEST_CASE("A missing file of a scene is named, and the rest of the state is restored") {
    const auto folder = testFolder() / "scene-with-files";
    std::filesystem::create_directories(folder / "bars");
    const auto scene = folder / "mine.json", coin = folder / "coin.modal",
               keys = folder / "keys.json", bar = folder / "bars/60.modal";
    std::ofstream(scene) << R"({"format": "idiophone-scene", "version": 1, "name": "Mine",
        "kinds": [{"name": "coin", "object": "coin.modal"}],
        "bodies": [{"kind": "coin", "at": [0, 0, 0.2]}],
        "keyboard": {"preset": "keys.json"}})";
    const std::string preset = R"({"format":"idiophone-preset","version":1,"name":"Bars","keyMap":)"
                               R"({"kind":"bars","lowestNote":60,"highestNote":61,"object":)";
    std::ofstream(keys) << preset + R"("bars/{note}.modal"}})";
    const auto object = encodeModalObject(*ObjectLibrary::shared().find("die").value());
    for (const auto& file : {coin, bar, folder / "bars/61.modal"})
        std::ofstream(file, std::ios::binary)
            .write(reinterpret_cast<const char*>(object.data()),
                   static_cast<std::streamsize>(object.size()));
    const auto state = songOf(scene);
    const auto bytes = encodeState(state);
    const auto presetFile = juce::File((folder / "preset.json").string());
    Processor whole;
    restoreBytes(whole, bytes);
    INFO(whole.view().status.takeStatus().sentence);
    REQUIRE_FALSE(whole.view().status.takeStatus().isError);
    REQUIRE(whole.view().stage.hasStage());

    for (const auto& gone : {coin, keys, bar}) {
        const auto kept = gone.string() + ".kept";
        std::filesystem::rename(gone, kept);
        Processor processor;
        restoreBytes(processor, bytes);
        const auto end = gone.filename().string();
        const auto sentence = processor.view().status.takeStatus().sentence;
        INFO(sentence);
        CHECK(sentence.find("Test keyboard: ") == 0);
        CHECK(sentence.find(end + " is missing; until") != std::string::npos);
        CHECK(processor.view().parameters.value(ParameterId::size) == 1.5);
        CHECK(saved(processor) == bytes);
        const auto built = buildPresetInstrument(state.preset.keyMap, presetFile);
        REQUIRE(built);
        CHECK(built->notice.find(end + " is missing") != std::string::npos);
        std::filesystem::rename(kept, gone);
    }
    Processor again;
    restoreBytes(again, bytes);
    CHECK_FALSE(again.view().status.takeStatus().isError);

    // A file that exists but cannot be used is an error, and so is a keyboard that names its own
    // scene.
    for (const auto& text : {preset + R"(1}})", R"({"format":"idiophone-preset","version":1,)"
                                                R"("name":"Bars","keyMap":{"kind":"scene",)"
                                                R"("object":"mine.json"}})" +
                                                    std::string()}) {
        std::ofstream(keys) << text;
        Processor processor;
        restoreBytes(processor, bytes);
        CHECK(processor.view().status.takeStatus().sentence.find(
                  "The saved state cannot be played") == 0);
    }
}

TEST_CASE("A scene in one user's settings folder is found in another user's") {
    const UserSettings user;
    const auto named = [](const std::string& path) {
        auto state = songOf({});
        state.preset.keyMap.object = path;
        return encodeState(state);
    };
    const auto plays = [](const std::string& bytes) {
        Processor processor;
        restoreBytes(processor, bytes);
        const bool isRefused =
            processor.view().status.takeStatus().sentence.starts_with("The saved state");
        CHECK((isRefused ||
               saved(processor) == bytes)); // the state keeps the path of its own machine
        return processor.view().stage.hasStage();
    };
    const std::string anns[] = {"/home/ann/.config/Idiophone/Scenes/mine.json",
                                "/home/ann/Idiophone/config/Idiophone/Scenes/mine.json",
                                "C:/Users/ann/AppData/Roaming/Idiophone/Scenes/mine.json"};
    for (const auto& path : anns)
        CHECK_FALSE(plays(named(path)));
    user.write("Scenes/mine.json", mine);
    for (const auto& path : anns)
        CHECK(plays(named(path)));
    for (const auto* path : {"/home/ann/Scenes/mine.json", "/home/ann/.config/Idiophone/mine.json",
                             "/home/ann/.config/Idiophone/Scenes", "Idiophone/", ""})
        CHECK_FALSE(plays(named(path)));

    // An existing file at the given path takes precedence.
    const auto other = testFolder() / "Idiophone/Scenes";
    std::filesystem::create_directories(other);
    std::ofstream(other / "mine.json") << "damaged";
    CHECK_FALSE(plays(named((other / "mine.json").string())));
}
