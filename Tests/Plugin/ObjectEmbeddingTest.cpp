#include "Plugin/ObjectEmbedding.h"

#include "Instrument/FactoryContent.h"
#include "Object/FileBytes.h"
#include "Plugin/PresetObjects.h"
#include "Support/TestFolder.h"
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <filesystem>
#include <thread>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("An object from a file is saved in the state and outlives the file") {
    const auto file = testFolder() / "embedded.modal";
    REQUIRE(writeModalObject(syntheticObject({440, 1000}), file));
    auto state = testState();
    state.preset.keyMap.object = file.string();
    state.preset.keyMap.kind = KeyMapKind::zones;
    state.objects.clear();

    Processor first;
    restore(first, state);
    REQUIRE(first.soundSession().instrument()->keyMap() == state.preset.keyMap);
    const auto bytes = saved(first);
    std::filesystem::remove(file);
    const auto embedded = parseState(bytes);
    REQUIRE(embedded);
    REQUIRE(embedded->objects.size() == 1);
    CHECK(embedded->objects[0].name == file.string());

    Processor second;
    restoreBytes(second, bytes);
    REQUIRE(second.soundSession().instrument() != nullptr);
    CHECK(second.soundSession().instrument()->keyMap() == state.preset.keyMap);
    CHECK(saved(second) == bytes);
}

TEST_CASE("A factory instrument embeds no object") {
    for (const auto& preset : factoryPresets()) {
        const auto instrument = buildInstrument(preset.keyMap, {});
        INFO(preset.name);
        REQUIRE(instrument);
        CHECK(foreignObjects(**instrument).empty());
    }
}

TEST_CASE("An embedded object cannot replace a factory object") {
    const auto& preset = factoryPresets().front();
    const auto before = buildInstrument(preset.keyMap, {});
    REQUIRE(before);
    auto name = preset.keyMap.object;
    if (const auto mark = name.find("{note}"); mark != std::string::npos)
        name.replace(mark, 6, std::to_string(preset.keyMap.lowestNote));
    REQUIRE(factoryObject(name));
    const EmbeddedObject impostor{.name = name, .modal = encodeModalObject(syntheticObject({100}))};
    const auto after = buildInstrument(preset.keyMap, {impostor});
    REQUIRE(after);
    CHECK((*after)->slots()[0].object == (*before)->slots()[0].object);
}

TEST_CASE("A damaged embedded object gives one sentence that names it") {
    auto state = testState();
    state.objects[3].modal.resize(20);
    const auto built = buildInstrument(state.preset.keyMap, state.objects);
    REQUIRE_FALSE(built);
    CHECK_THAT(built.error().message, ContainsSubstring("test/63"));
}

TEST_CASE("Each object is packed once while it lives") {
    auto state = testState("packed once");
    for (auto& object : state.objects)
        object.packed = nullptr;
    const auto textsOf = [](const Instrument& instrument) {
        std::vector<const std::string*> texts;
        for (const auto& object : embeddedObjects(instrument))
            texts.push_back(object.packed.get());
        return texts;
    };
    std::weak_ptr<const std::string> text;
    {
        const auto built = buildInstrument(state.preset.keyMap, state.objects);
        REQUIRE(built);
        const auto first = textsOf(**built);
        REQUIRE(first.size() == state.objects.size());
        CHECK(textsOf(**built) == first);
        text = embeddedObjects(**built).front().packed;
        CHECK_FALSE(text.expired());
    }
    SECTION("its text is freed when factory objects are saved") {
        embeddedObjects(**buildInstrument(factoryPresets().front().keyMap, {}));
        CHECK(text.expired());
    }
    SECTION("its text is freed when packed objects are restored") {
        auto another = testState("another");
        for (auto& object : another.objects)
            object.packed = std::make_shared<const std::string>("its own text");
        CHECK(buildInstrument(another.preset.keyMap, another.objects));
        CHECK(text.expired());
    }
}

TEST_CASE("An object restored with its packed text is saved with the same text") {
    auto state = testState("as it came");
    for (auto& object : state.objects)
        object.packed = std::make_shared<const std::string>("its own text");
    const auto built = buildInstrument(state.preset.keyMap, state.objects);
    REQUIRE(built);
    for (const auto& object : embeddedObjects(**built))
        CHECK(*object.packed == "its own text");
}

TEST_CASE("An embedded object is not shared, even if a file has its name") {
    const auto file = testFolder() / "same-name.modal";
    REQUIRE(writeModalObject(syntheticObject({440}), file));
    const KeyMap map{.kind = KeyMapKind::zones, .object = storedNameOf(file)};
    const auto lowest = [](const Result<std::shared_ptr<const Instrument>>& built) {
        return (*built)->slots()[0].object->eigenvalues[0];
    };
    const auto of = [](double hertz) { return syntheticObject({hertz}).eigenvalues[0]; };
    const auto embedded = buildInstrument(
        map, {{.name = map.object, .modal = encodeModalObject(syntheticObject({100}))}});
    const auto opened =
        buildSingleObject(map, std::make_shared<const ModalObject>(syntheticObject({200})));
    const auto otherKeys = rebuilt(**embedded, {.kind = KeyMapKind::scaled, .object = map.object});
    CHECK(lowest(embedded) == of(100));
    CHECK(lowest(opened) == of(200));
    CHECK((*otherKeys)->slots()[0].object == (*embedded)->slots()[0].object);
    const auto played = buildInstrument(map, {});
    CHECK(lowest(played) == of(440));
    const auto preset = buildPresetInstrument(map, juce::File((testFolder() / "p.json").string()));
    CHECK(preset->instrument->slots()[0].object == (*played)->slots()[0].object);
}

TEST_CASE("Objects too large for a state are refused before they play") {
    // A link for every note, all to one file of nine megabytes.
    const auto folder = testFolder() / "large";
    std::filesystem::create_directories(folder);
    auto large = syntheticObject({440});
    large.vertices.resize(2'250'000);
    REQUIRE(writeModalObject(large, folder / "all"));
    for (int note = 0; note < 128; ++note) {
        std::error_code fault;
        const auto file = folder / (std::to_string(note) + ".modal");
        std::filesystem::remove(file, fault);
        std::filesystem::create_symlink(folder / "all", file, fault);
        if (fault)
            SKIP("no links between files here");
    }
    KeyMap map{.lowestNote = 0, .highestNote = 127, .object = (folder / "{note}.modal").string()};
    const auto preset = juce::File((folder / "preset.json").string());
    const std::string sentence = "its objects take more than the 1 GiB that a project can hold";
    CHECK(buildInstrument(map, {}).error().message == sentence);
    CHECK(buildPresetInstrument(map, preset).error().message == sentence);
    Processor processor;
    auto state = testState();
    state.objects.clear();
    state.preset.keyMap = map;
    restore(processor, state);
    CHECK_THAT(processor.view().status.takeStatus().sentence, ContainsSubstring(sentence));

    state.preset.keyMap.highestNote = map.highestNote = 99;
    CHECK(buildPresetInstrument(map, preset));
    restore(processor, state);
    CHECK_FALSE(processor.view().status.takeStatus().isError);
    const auto bytes = saved(processor);
    restore(processor, testState());
    restoreBytes(processor, bytes);
    CHECK_FALSE(processor.view().status.takeStatus().isError);
    CHECK(saved(processor) == bytes);
}

TEST_CASE("Instances that restore different objects of one name in parallel each get their own") {
    const auto low = testState("same", 1), high = testState("same", 2);
    std::atomic<int> wrong{0};
    const auto build = [&](const State& state, double expectedHz) {
        for (int i = 0; i < 50; ++i) {
            const auto built = buildInstrument(state.preset.keyMap, state.objects);
            const double lambda = (*built)->slots()[0].object->eigenvalues[0];
            if (std::abs(std::sqrt(lambda) / (2 * std::numbers::pi) - expectedHz) > 0.01)
                ++wrong;
        }
    };
    const double lowestHz = 440 * std::exp2((lowestTestNote - 69) / 12.0);
    std::thread other([&] { build(high, 2 * lowestHz); });
    build(low, lowestHz);
    other.join();
    CHECK(wrong == 0);
}
