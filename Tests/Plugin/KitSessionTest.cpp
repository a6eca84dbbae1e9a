// Tests edits of kits as the window makes them: each is a step of undo and keeps the objects.
#include "Instrument/FactoryContent.h"
#include "Plugin/FactoryPrograms.h"
#include "Plugin/KitSound.h"
#include "Plugin/PresetsAtHand.h"
#include "Support/ImportedFiles.h"
#include "Support/TestSound.h"
#include "Support/UserSettings.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <functional>
#include <set>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

/// A processor with the test keyboard, 60 to 72, and its views.
struct Rig {
    explicit Rig(bool isKit = true) {
        restore(processor, testState());
        processor.prepareToPlay(testRateHz, 512);
        if (isKit)
            kit.makeKit();
    }

    KitView::Part part(std::size_t index) { return kit.kitParts().at(index); }
    void change(std::size_t index, const std::function<void(KitView::Part&)>& edit) {
        auto wanted = part(index);
        edit(wanted);
        kit.changePart(index, wanted);
    }
    std::shared_ptr<const Instrument> instrument() { return processor.soundSession().instrument(); }
    std::set<const ModalObject*> objects() {
        std::set<const ModalObject*> all;
        for (const auto& slot : instrument()->slots())
            all.insert(slot.object.get());
        return all;
    }
    std::string sentence() { return processor.view().status.takeStatus().sentence; }
    float loudestOf(int note, int velocity = 100) {
        render(processor, 9600, 512, {}); // the crossfade
        processor.reset();
        juce::MidiBuffer midi;
        midi.addEvent(juce::MidiMessage::noteOn(1, note, static_cast<juce::uint8>(velocity)), 10);
        return loudest(render(processor, 4800, 512, midi));
    }

    Processor processor;
    KitView& kit = processor.view().kit;
    SoundHistory& history = processor.windowSession().history;
};

/// A file that needs no analysis.
std::filesystem::path cowbell() {
    auto object = syntheticObject({580, 870});
    object.name = "Cowbell";
    const auto file = testFolder() / "Cowbell.modal";
    REQUIRE(writeModalObject(object, file));
    return file;
}

} // namespace

TEST_CASE("A kit made of a sound sounds as before, in one step of undo") {
    Rig rig(false);
    CHECK(rig.kit.kitParts().empty());
    REQUIRE(rig.kit.canBeKit());
    const auto before = rig.instrument()->keyMap();
    const auto loudness = rig.loudestOf(64);
    rig.kit.makeKit();
    REQUIRE(rig.kit.kitParts().size() == 1);
    CHECK(rig.part(0) == KitView::Part{.object = "test", .lowestNote = 60, .highestNote = 72});
    CHECK(rig.loudestOf(64) == Approx(loudness).epsilon(1e-4));
    CHECK(rig.history.undoName() == "Make a kit");
    rig.history.undo();
    CHECK(rig.instrument()->keyMap() == before);
    CHECK_FALSE(rig.history.canUndo());
}

TEST_CASE("A scene can be no kit, and the reason is given") {
    Rig rig;
    REQUIRE(rig.processor.view().presets.loadPreset(factoryPresetId("Falling Rings")));
    REQUIRE_FALSE(rig.kit.canBeKit());
    CHECK(rig.kit.canBeKit().error().message == "the keys play a scene");
    rig.kit.makeKit();
    CHECK(rig.sentence() == "This sound cannot be a kit: the keys play a scene.");
}

TEST_CASE("Each figure of a part changes in one step of undo, and no object is built anew") {
    using Edit = std::function<void(KitView::Part&)>;
    const std::vector<std::pair<const char*, Edit>> edits{
        {"Keys", [](KitView::Part& part) { part.lowestNote = 64; }},
        {"Velocities", [](KitView::Part& part) { part.highestVelocity = 90; }},
        {"Level", [](KitView::Part& part) { part.levelDb = -4.5; }},
        {"Choke group", [](KitView::Part& part) { part.chokeGroup = 3; }},
        {"Output", [](KitView::Part& part) { part.output = 2; }},
        {"Material", [](KitView::Part& part) { part.material = firstLibraryMaterial + 2; }},
        {"Mallet", [](KitView::Part& part) { part.mallet = firstRackMallet + 1; }}};
    Rig rig;
    const auto objects = rig.objects();
    for (const auto& [name, edit] : edits) {
        INFO(name);
        const auto before = rig.part(0);
        auto wanted = before;
        edit(wanted);
        rig.change(0, edit);
        CHECK(rig.part(0) == wanted);
        CHECK(rig.history.undoName() == std::string(name) + " of test");
        CHECK(std::ranges::includes(objects, rig.objects()));
        rig.history.undo();
        CHECK(rig.part(0) == before);
        CHECK(rig.history.undoName() == "Make a kit");
        rig.change(0, [](KitView::Part&) {});
        CHECK(rig.history.undoName() == "Make a kit");
    }
}

TEST_CASE("A part is heard on its keys and velocities and at its level") {
    Rig rig;
    const float before = rig.loudestOf(64);
    rig.change(0, [](KitView::Part& part) { part.levelDb = -12; });
    CHECK(rig.loudestOf(64) == Approx(before * std::pow(10, -12 / 20.0)).epsilon(0.02));
    rig.change(0, [](KitView::Part& part) {
        part.lowestNote = 64;
        part.highestVelocity = 90;
    });
    CHECK(rig.loudestOf(64, 90) > 0);
    CHECK(rig.loudestOf(64, 91) == 0);
    CHECK(rig.loudestOf(63, 90) == 0);
}

TEST_CASE("A change during sound does not click") {
    const auto steepest = [](const std::vector<float>& samples) {
        float largest = 0;
        for (std::size_t i = 2; i < samples.size(); ++i)
            largest = std::max(largest, std::abs(samples[i] - 2 * samples[i - 1] + samples[i - 2]));
        return largest;
    };
    Rig rig;
    render(rig.processor, 9600, 512, {});
    juce::MidiBuffer chord;
    for (const int note : {60, 64, 67})
        chord.addEvent(juce::MidiMessage::noteOn(1, note, static_cast<juce::uint8>(100)), 0);
    const auto ringing = render(rig.processor, 4800, 512, chord).left;
    rig.change(0, [](KitView::Part& part) { part.levelDb = 12; });
    CHECK(steepest(render(rig.processor, 9600, 512, {}).left) <= steepest(ringing));
}

TEST_CASE("Figures out of range are clamped, and the custom material is none of a part") {
    Rig rig;
    rig.change(0, [](KitView::Part& part) {
        part.lowestNote = 70;
        part.highestNote = 62;
        part.lowestVelocity = -3;
        part.highestVelocity = 300;
        part.levelDb = 99;
        part.chokeGroup = 99;
        part.material = customMaterial;
        part.mallet = 1000;
    });
    const auto part = rig.part(0);
    CHECK(part.lowestNote == 62);
    CHECK(part.highestNote == 70);
    CHECK(part.lowestVelocity == 1);
    CHECK(part.highestVelocity == 127);
    CHECK(part.levelDb == KitView::maximumLevelDb);
    CHECK(part.chokeGroup == KitView::chokeGroups);
    CHECK_FALSE(part.material);
    CHECK(part.mallet == static_cast<int>(parameterInfo(ParameterId::mallet).maximum));
    rig.kit.changePart(7, part); // no such part
    rig.kit.removePart(7);
    CHECK(rig.kit.kitParts() == std::vector{part});
}

TEST_CASE("A third layer on a key and a key without a bar are refused, and the part stays") {
    Rig rig;
    REQUIRE(rig.processor.view().presets.loadPreset(factoryPresetId("Junkyard Kit")));
    for (const std::size_t moved : {1u, 2u}) {
        const auto before = rig.kit.kitParts();
        rig.change(moved, [](KitView::Part& part) { part.lowestNote = part.highestNote = 36; });
        CHECK((rig.kit.kitParts() == before) == (moved == 2));
    }
    CHECK(rig.sentence() == "Brake drum stays as it was: the kit's parts are more than 2 on key 36 "
                            "at velocity 1.");
    REQUIRE(rig.processor.view().presets.loadPreset(factoryPresetId("Marimba")));
    rig.kit.makeKit();
    const auto marimba = rig.part(0);
    CHECK(marimba.object == "Marimba");
    rig.change(0, [](KitView::Part& part) { part.lowestNote = 20; });
    CHECK(rig.part(0) == marimba);
    CHECK(rig.sentence() == "Marimba stays as it was: it has no bar for G#0.");
}

TEST_CASE("A removed part is silent and comes back with undo; the last part stays") {
    Rig rig;
    rig.processor.view().workshop.openFileOnKey(cowbell(), 40);
    finish(rig.processor);
    REQUIRE(rig.kit.kitParts().size() == 2);
    CHECK(rig.loudestOf(40) > 0);
    rig.kit.removePart(1);
    CHECK(rig.kit.kitParts().size() == 1);
    CHECK(rig.history.undoName() == "Remove Cowbell");
    CHECK(rig.loudestOf(40) == 0);
    rig.kit.removePart(0);
    CHECK(rig.kit.kitParts().size() == 1);
    CHECK(rig.sentence() == "test stays: a kit has at least one part.");
    rig.history.undo();
    CHECK(rig.part(1).object == "Cowbell");
    CHECK(rig.loudestOf(40) > 0);
}

TEST_CASE("Keys that a part keeps have the strike and the voicing that they had") {
    const auto& map = findFactoryPreset("Rosewood Xylophone")->keyMap;
    REQUIRE_FALSE(map.voicingDb.empty());
    const int middle = (map.lowestNote + map.highestNote) / 2;
    const auto moved = onKeys(map, middle, map.highestNote + 2);
    CHECK(moved.resizedFrom == middle);
    CHECK(moved.resizedTo == map.highestNote + 2);
    for (int note = middle; note <= map.highestNote; ++note) {
        CHECK(moved.strikePlace(note) == Approx(map.strikePlace(note)));
        CHECK(moved.voicingDb.at(static_cast<std::size_t>(note - middle)) ==
              map.voicingDb.at(static_cast<std::size_t>(note - map.lowestNote)));
    }
    CHECK(moved.voicingDb.back() == map.voicingDb.back());
    const KeyMap path{
        .kind = KeyMapKind::zones, .lowestNote = 40, .highestNote = 40, .object = "plate"};
    CHECK(onKeys(path, 40, 52).strikeAt == path.strikeAt);
    CHECK(onKeys(path, 40, 52).strikePlace(46) == 0.5);
}

TEST_CASE("An edited kit is saved in states and presets, and is the factory's preset no more") {
    const UserSettings user;
    Rig rig;
    REQUIRE(rig.processor.view().presets.loadPreset(factoryPresetId("Junkyard Kit")));
    rig.change(0, [](KitView::Part& part) {
        part.highestNote = 40;
        part.highestVelocity = 64;
        part.levelDb = -20.5;
        part.chokeGroup = 2;
        part.material.reset();
        part.mallet = firstRackMallet;
    });
    rig.kit.removePart(5);
    rig.processor.view().workshop.openFileOnKey(cowbell(), 70);
    finish(rig.processor);
    REQUIRE(rig.kit.kitParts().back().object == "Cowbell");
    const auto parts = rig.kit.kitParts();
    CHECK(rig.processor.soundSession().loadedSound().presetId.empty());
    Processor opened;
    restoreBytes(opened, saved(rig.processor));
    CHECK(opened.view().kit.kitParts() == parts);
    auto& shelf = rig.processor.view().presets;
    REQUIRE(shelf.savePreset(called("My kit"), false));
    const auto* mine = find(shelf, "My kit");
    REQUIRE(mine != nullptr);
    REQUIRE(opened.view().presets.loadPreset(mine->id));
    CHECK(opened.view().kit.kitParts() == parts);
    rig.change(0, [](KitView::Part& part) { part.levelDb = 3; });
    REQUIRE(shelf.saveChosenPreset()); // it is a preset of one's own
    opened.view().presets.readPresets();
    REQUIRE(opened.view().presets.loadPreset(mine->id));
    CHECK(opened.view().kit.kitParts().at(0).levelDb == 3);
}
