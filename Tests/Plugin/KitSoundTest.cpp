// Tests objects that are put on single keys: the sound becomes a kit, and travels with all its
// objects.
#include "Plugin/KitSound.h"
#include "Instrument/PhrasePrediction.h"
#include "Object/ModalObjectFile.h"
#include "Plugin/FactoryPrograms.h"
#include "Plugin/Processor.h"
#include "Support/ImportedFiles.h"
#include "Support/SyntheticObject.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double rateHz = 48000;

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

std::shared_ptr<const Instrument> instrumentOf(Processor& processor) {
    return processor.soundSession().loadedSound().instrument;
}

} // namespace

TEST_CASE("An object dropped on a key makes a kit, and undo takes it back") {
    Processor processor;
    processor.prepareToPlay(rateHz, 512);
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
        processor.prepareToPlay(rateHz, 512);
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
    processor.prepareToPlay(rateHz, 512);
    choose(processor, "Marimba");
    dropOnKey(processor, cowbell(), 30);
    const auto sound = processor.soundSession().loadedSound();
    const auto loudness = [&](int note) {
        Phrase phrase(sound.instrument, sound.preset.surface, rateHz);
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
    processor.prepareToPlay(rateHz, 512);
    choose(processor, "Falling Rings");
    dropOnKey(processor, cowbell(), 60);
    const auto status = processor.view().status.takeStatus();
    CHECK(status.isError);
    CHECK(status.sentence == "Cowbell cannot be put on C4: the keys play a scene.");
}
