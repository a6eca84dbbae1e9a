#include "Plugin/PresetObjects.h"
#include "Instrument/ObjectLibrary.h"

#include "Instrument/FactoryContent.h"
#include "Object/ModalObjectFile.h"
#include "Scene/SceneStage.h"
#include "Support/SyntheticObject.h"
#include "Support/TestFolder.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;

namespace {

juce::File freshFolder() {
    const auto folder = juce::File(testFolder().string()).getChildFile("Presets");
    folder.deleteRecursively();
    return folder;
}

struct Played {
    KeyMap keyMap;
    std::shared_ptr<const Instrument> instrument;
};

Played bowl(const std::string& name, double frequencyHz) {
    ObjectLibrary library;
    const auto kept = library.add(name, syntheticObject({frequencyHz, 3 * frequencyHz}));
    const KeyMap map{
        .kind = KeyMapKind::scaled, .lowestNote = 48, .highestNote = 60, .object = name};
    return {map, Instrument::build(map, library).value()};
}

Played keyboard(const std::string& name) {
    ObjectLibrary library;
    std::vector<std::shared_ptr<const ModalObject>> kept;
    KeyMap map{.kind = KeyMapKind::bars, .lowestNote = 60, .highestNote = 64, .object = name};
    for (int note = 60; note <= 64; ++note)
        kept.push_back(library.add(map.objectFor(note), syntheticObject({note * 10.0})));
    return {map, Instrument::build(map, library).value()};
}

int filesOfObjects(const juce::File& folder) {
    return folder.getNumberOfChildFiles(juce::File::findFiles, "*") +
           (folder.getChildFile("Objects").isDirectory()
                ? folder.getChildFile("Objects")
                      .findChildFiles(juce::File::findFiles, true, "*.modal")
                      .size()
                : 0);
}

bool sameObjects(const Instrument& a, const Instrument& b) {
    return std::ranges::equal(a.slots(), b.slots(), [](const auto& x, const auto& y) {
        return encodeModalObject(*x.object) == encodeModalObject(*y.object) &&
               x.sizeRatio == y.sizeRatio;
    });
}

} // namespace

TEST_CASE("A foreign object is written once and read back byte for byte") {
    const auto folder = freshFolder();
    const auto played = bowl("/home/somebody/My bowl.modal", 300);
    const auto stored = writePresetObjects(played.keyMap, *played.instrument, folder);
    REQUIRE(stored);
    CHECK_THAT(stored->object, StartsWith("Objects/"));
    CHECK(filesOfObjects(folder) == 1);
    CHECK(writePresetObjects(played.keyMap, *played.instrument, folder).value() == *stored);
    CHECK(filesOfObjects(folder) == 1);

    const auto built = buildPresetInstrument(*stored, folder.getChildFile("Bells/x.json"));
    REQUIRE(built);
    CHECK(sameObjects(*built->instrument, *played.instrument));
    CHECK(built->instrument->keyMap() == *stored);
    // Saving the objects again gives the same file.
    CHECK(writePresetObjects(*stored, *built->instrument, folder).value() == *stored);
    CHECK(filesOfObjects(folder) == 1);
}

TEST_CASE("Two objects with the same name do not overwrite each other") {
    const auto folder = freshFolder();
    const auto first = bowl("bowl.obj", 300), second = bowl("bowl.obj", 500);
    const auto firstStored = writePresetObjects(first.keyMap, *first.instrument, folder).value();
    const auto secondStored = writePresetObjects(second.keyMap, *second.instrument, folder).value();
    CHECK(firstStored.object != secondStored.object);
    const auto preset = folder.getChildFile("x.json");
    CHECK(sameObjects(*buildPresetInstrument(firstStored, preset)->instrument, *first.instrument));
    CHECK(
        sameObjects(*buildPresetInstrument(secondStored, preset)->instrument, *second.instrument));
}

TEST_CASE("All objects of a foreign keyboard are written") {
    const auto folder = freshFolder();
    const auto played = keyboard("stones/{note}");
    const auto stored = writePresetObjects(played.keyMap, *played.instrument, folder);
    REQUIRE(stored);
    CHECK(filesOfObjects(folder) == 5);
    const auto built = buildPresetInstrument(*stored, folder.getChildFile("x.json"));
    REQUIRE(built);
    CHECK(sameObjects(*built->instrument, *played.instrument));
}

TEST_CASE("Factory objects are not written") {
    const auto folder = freshFolder();
    for (const auto& preset : factoryPresets()) {
        const auto instrument = buildInstrument(preset.keyMap, ObjectLibrary::shared()).value();
        CHECK(writePresetObjects(preset.keyMap, *instrument, folder).value() == preset.keyMap);
    }
    CHECK_FALSE(folder.exists());
}

TEST_CASE("A moved preset folder opens with its objects, and instances share them") {
    const auto folder = freshFolder();
    const auto played = bowl("bowl.obj", 300);
    const auto stored = writePresetObjects(played.keyMap, *played.instrument, folder).value();
    const auto elsewhere = juce::File(testFolder().string()).getChildFile("elsewhere/From Anna");
    elsewhere.getParentDirectory().deleteRecursively();
    elsewhere.getParentDirectory().createDirectory();
    REQUIRE(folder.moveFileTo(elsewhere));
    const auto preset = elsewhere.getChildFile("x.json");
    const auto first = buildPresetInstrument(stored, preset);
    const auto second = buildPresetInstrument(stored, preset);
    REQUIRE((first && second));
    CHECK(sameObjects(*first->instrument, *played.instrument));
    CHECK(first->instrument->slots()[0].object == second->instrument->slots()[0].object);
}

TEST_CASE("A damaged object is an error that names it, and a missing one is replaced and named") {
    const auto folder = freshFolder();
    const auto played = bowl("bowl.obj", 300);
    const auto stored = writePresetObjects(played.keyMap, *played.instrument, folder).value();
    const auto object = folder.getChildFile(juce::String(stored.object));
    const auto preset = folder.getChildFile("x.json");
    object.replaceWithText("no object");
    const auto damaged = buildPresetInstrument(stored, preset);
    REQUIRE_FALSE(damaged);
    CHECK_THAT(damaged.error().message, ContainsSubstring(object.getFileName().toStdString()));
    // Saving again does not overwrite the changed file.
    const auto again = writePresetObjects(played.keyMap, *played.instrument, folder).value();
    CHECK(again != stored);
    CHECK(object.loadFileAsString() == "no object");
    CHECK(sameObjects(*buildPresetInstrument(again, preset)->instrument, *played.instrument));
    CHECK(writePresetObjects(played.keyMap, *played.instrument, folder).value() == again);
    object.deleteFile();
    const auto missing = buildPresetInstrument(stored, preset);
    REQUIRE(missing);
    CHECK_THAT(missing->notice, ContainsSubstring(object.getFileName().toStdString()));
    CHECK(missing->keyMap.object == "ring");
    for (const int note : {stored.lowestNote, stored.highestNote})
        CHECK(missing->instrument->key(note).slot >= 0);
}

TEST_CASE("Objects with hostile names are written inside the folder only") {
    for (const auto* name : {"../../../evil", "/etc/passwd", "..", "a\\..\\b", "", "x\ny", "{note}",
                             "Objects/../../x.modal"}) {
        const auto folder = freshFolder();
        const auto played = bowl(name, 300);
        const auto stored = writePresetObjects(played.keyMap, *played.instrument, folder);
        REQUIRE(stored);
        INFO(name << " " << stored->object);
        CHECK(folder.getChildFile(juce::String(stored->object)).isAChildOf(folder));
        CHECK(filesOfObjects(folder) == 1);
    }
}

TEST_CASE("An object file is named after the last part of the object's path on any system") {
    for (const auto* name : {"Bowl.modal", "/bells/Bowl.modal", "C:/Bells/Bowl.modal",
                             "C:\\Bells\\Bowl.modal", "\\\\server\\Bells\\Bowl.modal"}) {
        const auto played = bowl(name, 300);
        const auto stored = writePresetObjects(played.keyMap, *played.instrument, freshFolder());
        REQUIRE(stored);
        CHECK_THAT(stored->object, StartsWith("Objects/Bowl-"));
    }
}

TEST_CASE("A key without its bar plays its neighbour, and a missing lowest bar becomes a ring") {
    const auto folder = freshFolder();
    const KeyMap map{.kind = KeyMapKind::bars,
                     .lowestNote = 60,
                     .highestNote = 64,
                     .object = "Objects/Set/{note}.modal"};
    const auto bar = bowl("bowl.obj", 300).instrument->slots().front().object;
    const auto bytes = encodeModalObject(*bar);
    REQUIRE(folder.getChildFile("Objects/Set").createDirectory().wasOk());
    for (int note = map.lowestNote; note <= map.highestNote; ++note)
        folder.getChildFile(juce::String(map.objectFor(note)))
            .replaceWithData(bytes.data(), bytes.size());
    const auto preset = folder.getChildFile("x.json");
    CHECK(buildPresetInstrument(map, preset)->notice.empty());
    folder.getChildFile(juce::String(map.objectFor(62))).deleteFile();
    const auto gapped = buildPresetInstrument(map, preset);
    REQUIRE(gapped);
    CHECK(gapped->notice.empty());
    CHECK(gapped->keyMap == map);
    CHECK(gapped->instrument->key(62).slot >= 0);
    CHECK_FALSE(gapped->instrument->hasOwn(62));
    CHECK(gapped->instrument->hasOwn(63));
    folder.getChildFile(juce::String(map.objectFor(60))).deleteFile();
    const auto built = buildPresetInstrument(map, preset);
    REQUIRE(built);
    CHECK_THAT(built->notice, ContainsSubstring("60.modal is missing"));
    CHECK(built->keyMap.object == "ring");
    CHECK(built->instrument->key(62).slot >= 0);
}
