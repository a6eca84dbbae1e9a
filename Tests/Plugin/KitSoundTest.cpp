// Tests objects that are put on single keys: the sound becomes a kit, and travels with all its
// objects.
#include "Plugin/KitSound.h"
#include "Instrument/PhrasePrediction.h"
#include "Object/ModalObjectFile.h"
#include "Plugin/FactoryPrograms.h"
#include "Plugin/Processor.h"
#include "Support/ImportedFiles.h"
#include "Support/SyntheticObject.h"
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

std::filesystem::path cowbell() {
    auto object = syntheticObject({580, 870});
    object.name = "Cowbell";
    const auto bytes = encodeModalObject(object);
    return writtenFile("Cowbell.modal",
                       std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

void dropOnKey(Processor& processor, const std::filesystem::path& file, int midiNote) {
    processor.view().workshop.openFileOnKey(file, midiNote);
    finish(processor);
}

void choose(Processor& processor, const char* preset) {
    REQUIRE(processor.view().presets.loadPreset(factoryPresetId(preset)));
}

/// A file whose analysis is so short that a test can wait for it, and that has a preview.
std::filesystem::path plate() {
    return meshFile("plate.obj", sheetMesh(0.045, 0.027, 60));
}

std::shared_ptr<const Instrument> instrumentOf(Processor& processor) {
    return processor.soundSession().loadedSound().instrument;
}

std::shared_ptr<const ModalObject> objectOn(Processor& processor, int midiNote) {
    const auto playing = instrumentOf(processor);
    const int slot = playing->key(midiNote).slot;
    return slot < 0 ? nullptr : playing->slots()[static_cast<std::size_t>(slot)].object;
}

/// A processor with a kit of the test keyboard, 60 to 72.
struct Rig {
    Rig() {
        restore(processor, testState());
        processor.prepareToPlay(testRateHz, 512);
        kit.makeKit();
    }

    bool isHeard(int midiNote) {
        render(processor, 9600, 512, {}); // the crossfade
        processor.reset();
        juce::MidiBuffer midi;
        midi.addEvent(juce::MidiMessage::noteOn(1, midiNote, juce::uint8{100}), 10);
        return loudest(render(processor, 4800, 512, midi)) > 0;
    }

    Processor processor;
    KitView& kit = processor.view().kit;
    WorkshopView& workshop = processor.view().workshop;
    SoundHistory& history = processor.windowSession().history;
};

} // namespace

TEST_CASE("An object dropped on a key makes a kit, and undo takes it back") {
    Processor processor;
    processor.prepareToPlay(testRateHz, 512);
    choose(processor, "Marimba");
    const auto before = instrumentOf(processor);
    dropOnKey(processor, cowbell(), 30);
    const auto kit = instrumentOf(processor);
    REQUIRE(kit->keyMap().kind == KeyMapKind::kit);
    CHECK_FALSE(before->hasOwn(30));
    CHECK(kit->keysOf(30).size() == 1);
    CHECK(kit->slots()[static_cast<std::size_t>(kit->key(30).slot)].object->name == "Cowbell");
    CHECK(kit->key(60).strip != nullptr);
    CHECK(kit->keysOf(60).size() == 1);
    CHECK_FALSE(kit->hasOwn(31)); // a bar, resized, as before
    CHECK(processor.windowSession().history.undoName() == "Put Cowbell on F#1");

    dropOnKey(processor, cowbell(), 60); // beside the bar
    CHECK(instrumentOf(processor)->keysOf(60).size() == 2);
    dropOnKey(processor, cowbell(), 60); // replaces the first
    CHECK(instrumentOf(processor)->keysOf(60).size() == 2);
    CHECK(instrumentOf(processor)->keyMap().parts.size() == 3);
    for (int step = 0; step < 3; ++step)
        processor.windowSession().history.undo();
    CHECK(instrumentOf(processor)->keyMap() == before->keyMap());
}

TEST_CASE("A saved kit opens with all its objects where the files are gone") {
    juce::MemoryBlock state;
    KeyMap map;
    {
        Processor processor;
        processor.prepareToPlay(testRateHz, 512);
        choose(processor, "Glockenspiel");
        const auto file = cowbell();
        dropOnKey(processor, file, 40);
        std::filesystem::remove(file);
        map = instrumentOf(processor)->keyMap();
        processor.getStateInformation(state);
    }
    Processor opened;
    opened.setStateInformation(state.getData(), static_cast<int>(state.getSize()));
    const auto kit = instrumentOf(opened);
    REQUIRE(kit != nullptr);
    CHECK(kit->keyMap() == map);
    CHECK(kit->slots()[static_cast<std::size_t>(kit->key(40).slot)].object->name == "Cowbell");
}

TEST_CASE("An object on a key is as loud as the preset's own") {
    Processor processor;
    processor.prepareToPlay(testRateHz, 512);
    choose(processor, "Marimba");
    dropOnKey(processor, cowbell(), 30);
    const auto sound = processor.soundSession().loadedSound();
    const auto loudness = [&](int note) {
        Phrase phrase(sound.instrument, sound.preset.surface, testRateHz);
        for (auto& each : phrase.notes) {
            each.midiNote = note;
            each.key = sound.instrument->key(note);
        }
        return predictedLufs(phrase, sound.parameters);
    };
    CHECK(std::abs(loudness(30) - loudness(60)) < 8);
}

TEST_CASE("A key of a scene takes no object") {
    Processor processor;
    processor.prepareToPlay(testRateHz, 512);
    choose(processor, "Falling Rings");
    dropOnKey(processor, cowbell(), 60);
    const auto status = processor.view().status.takeStatus();
    CHECK(status.isError);
    CHECK(status.sentence == "Cowbell cannot be put on C4: the keys play a scene.");
}

TEST_CASE("A dropped mesh is heard on its key as a preview, which the whole object replaces") {
    Rig rig;
    std::shared_ptr<const ModalObject> preview;
    rig.workshop.openFileOnKey(plate(), 40);
    finish(rig.processor, [&] {
        if (preview != nullptr || !rig.workshop.playsPreview())
            return;
        preview = objectOn(rig.processor, 40);
        CHECK_FALSE(rig.workshop.importStatus().followsSettings);
        CHECK(rig.history.undoName() == "Put plate on E2");
        CHECK(rig.isHeard(40));
        auto part = rig.kit.kitParts().at(1);
        part.chokeGroup = 5;
        rig.kit.changePart(1, part); // the job goes on
    });
    REQUIRE(preview != nullptr);
    const auto whole = objectOn(rig.processor, 40);
    CHECK(whole != preview);
    CHECK(whole->modeCount() > 0);
    CHECK_FALSE(rig.workshop.playsPreview());
    CHECK(rig.kit.kitParts().at(1).chokeGroup == 5);
    CHECK(rig.isHeard(40));
    CHECK(rig.history.undoName() == "Choke group of plate");
    rig.history.undo();
    CHECK(rig.history.undoName() == "Put plate on E2");
    CHECK(objectOn(rig.processor, 40) == whole);
    rig.history.undo();
    CHECK(objectOn(rig.processor, 40) == nullptr);
    rig.history.redo();
    CHECK(objectOn(rig.processor, 40) == whole);
}

TEST_CASE("An object whose drop is undone during the preview comes back whole") {
    Rig rig;
    rig.workshop.openFileOnKey(plate(), 40);
    bool isUndone = false;
    std::weak_ptr<const ModalObject> preview;
    finish(rig.processor, [&] {
        if (!rig.workshop.playsPreview())
            return;
        preview = objectOn(rig.processor, 40);
        rig.history.undo();
        isUndone = true;
    });
    REQUIRE(isUndone);
    CHECK(rig.kit.kitParts().size() == 1);
    rig.history.redo();
    REQUIRE(rig.kit.kitParts().size() == 2);
    CHECK(preview.expired());
}

TEST_CASE("Files dropped on several keys are opened one after the other, until one is cancelled") {
    Rig rig;
    const auto file = cowbell();
    for (const int key : {40, 41, 42})
        rig.workshop.openFileOnKey(file, key);
    waitUntil([&] { return rig.kit.kitParts().size() == 4; }, [&] { rig.processor.poll(); });
    for (const int key : {40, 41, 42})
        CHECK(instrumentOf(rig.processor)->hasOwn(key));
    rig.workshop.openFileOnKey(plate(), 43);
    rig.workshop.openFileOnKey(file, 44);
    rig.workshop.cancelImport();
    finish(rig.processor);
    CHECK_FALSE(instrumentOf(rig.processor)->hasOwn(44));
    CHECK(rig.workshop.importStatus().stage == ImportStatus::Stage::cancelled);
}
