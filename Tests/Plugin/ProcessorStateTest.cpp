// Tests that states are saved and restored exactly, even while audio runs.
#include "Plugin/FactoryPrograms.h"
#include "Plugin/RestoredSound.h"
#include "Support/ImportedFiles.h"
#include "Support/UserSettings.h"

#include "Instrument/FactoryContent.h"
#include "Object/ModalObjectFile.h"

#include <catch2/catch_test_macros.hpp>
#include <thread>

using namespace idiophone;
using namespace idiophone::test;

TEST_CASE("A state restored into another instance is saved as the same bytes") {
    Processor first, second;
    restore(first, unusualState());
    std::mt19937 random(2);
    for (auto* parameter : first.getParameters())
        parameter->setValue(std::uniform_real_distribution<float>(0, 1)(random));
    const auto bytes = saved(first);
    restoreBytes(second, bytes);
    CHECK(saved(second) == bytes);
    for (std::size_t i = 0; i < parameterCount; ++i) {
        const auto id = static_cast<ParameterId>(i);
        CHECK(first.view().parameters.value(id) == second.view().parameters.value(id));
    }
}

TEST_CASE("A host that echoes every parameter after a restore does not change the state") {
    Processor processor;
    restore(processor, unusualState());
    const auto bytes = saved(processor);
    for (auto* parameter : processor.getParameters())
        parameter->setValueNotifyingHost(parameter->getValue());
    CHECK(saved(processor) == bytes);
}

TEST_CASE("The first block after a restore is bit-identical to the first render") {
    const auto expected = reference(unusualState());
    REQUIRE(loudest(expected) > 0.001f);

    SECTION("into a prepared instance") {
        Processor processor;
        processor.prepareToPlay(48000, blockSamples);
        restore(processor, unusualState());
        CHECK(firstBlock(processor) == expected);
    }
    SECTION("into an instance that has played another sound and is silent") {
        Processor processor;
        restore(processor, testState("other", 1.7));
        processor.prepareToPlay(48000, blockSamples);
        firstBlock(processor);
        processor.reset();
        restore(processor, unusualState());
        CHECK(firstBlock(processor) == expected);
    }
    SECTION("twice in a row, with a short block in between") {
        Processor processor;
        processor.prepareToPlay(48000, blockSamples);
        restore(processor, testState("other", 1.7));
        render(processor, 16, 16, {});
        restore(processor, unusualState());
        CHECK(firstBlock(processor) == expected);
    }
    SECTION("from another thread") {
        Processor processor;
        processor.prepareToPlay(48000, blockSamples);
        std::thread([&] { restore(processor, unusualState()); }).join();
        CHECK(firstBlock(processor) == expected);
    }
    SECTION("into an instance that is prepared again at another rate and back") {
        Processor processor;
        processor.prepareToPlay(96000, 64);
        render(processor, 640, 64, chord());
        restore(processor, unusualState());
        processor.releaseResources();
        processor.prepareToPlay(48000, blockSamples);
        CHECK(firstBlock(processor) == expected);
    }
}

TEST_CASE("Every sound that can be loaded can be saved and restored") {
    const UserSettings user;
    Processor first;
    const auto comesBack = [&] {
        INFO(first.soundSession().loadedSound().preset.name);
        CHECK_FALSE(first.view().status.takeStatus().isError);
        const auto bytes = saved(first);
        Processor second;
        restoreBytes(second, bytes);
        CHECK(second.view().status.takeStatus().sentence ==
              first.view().status.takeStatus().sentence);
        CHECK_FALSE(second.view().status.takeStatus().isError);
        CHECK(saved(second) == bytes);
    };
    SECTION("every program") {
        for (int program = 0; program < static_cast<int>(factoryPresets().size()); ++program) {
            first.setCurrentProgram(program);
            comesBack();
        }
    }
    SECTION("objects without a name, or with one that is not UTF-8") {
        for (const auto* name : {"", "\xff\xfe", "a/{note}\n"}) {
            auto object = syntheticObject({300, 700});
            object.name = name;
            const auto file = testFolder() / "nameless.modal";
            REQUIRE(writeModalObject(object, file));
            first.view().workshop.openFile(file);
            finish(first);
            CHECK((first.soundSession().loadedSound().preset.name == "nameless") ==
                  object.name.empty());
            comesBack();
            for (const auto layout : {KeyLayout::zones, KeyLayout::scaled}) {
                first.view().workshop.setKeyLayout(layout);
                comesBack();
            }
        }
    }
    SECTION("another analysis of an object without a name") {
        auto object = syntheticObject({300, 700});
        object.name.clear();
        for (auto& coordinate : object.vertices)
            coordinate *= 0.1f;
        auto state = testState();
        state.preset.keyMap.kind = KeyMapKind::zones;
        state.preset.keyMap.object = "without";
        state.objects = {{.name = "without", .modal = encodeModalObject(object)}};
        restore(first, state);
        first.view().workshop.analyseAgain();
        finish(first);
        CHECK(first.soundSession().loadedSound().preset.name == "Object");
        comesBack();
    }
    SECTION("scales with any bytes") {
        std::string text = "from 1995\n2\n600.\n1200.\n! ";
        text.resize(ScalaTuning::largestFileBytes, '\xe9');
        first.view().tuning.openTuning(writtenFile("any.scl", text));
        comesBack();
    }
    SECTION("the longest preset") {
        std::string text = R"({"format":"idiophone-preset","version":1,"name":"Long","keyMap":)"
                           R"({"kind":"zones","lowestNote":36,"highestNote":96,"object":"plate"},)"
                           R"("description":")";
        text.resize(largestPresetBytes - 2, 'x');
        user.write("Presets/Long.json", text + R"("})");
        REQUIRE(first.view().presets.loadPreset("Long.json"));
        comesBack();
    }
}

TEST_CASE("States are restored and saved from several threads while the audio runs") {
    Processor processor;
    processor.prepareToPlay(48000, 256);
    const auto stateOf = [](const char* folder, double size) {
        auto state = testState(folder);
        state.parameters.set(ParameterId::size, size);
        return encodeState(state);
    };
    const auto a = stateOf("a", 1), b = stateOf("b", 2);
    std::atomic<bool> stop{false}, finite{true}, whole{true};
    std::thread audio([&] {
        while (!stop)
            if (!allFinite(render(processor, 256, 256, testMusic(256, 50))) ||
                processor.engineReport().notFinite > 0)
                finite = false;
    });
    const auto hammer = [&](const std::string& bytes) {
        for (int i = 0; i < 40; ++i) {
            restoreBytes(processor, bytes);
            const auto now = parseState(saved(processor));
            // The parameters must belong to the preset.
            const double size = now ? now->parameters[ParameterId::size] : 0;
            if (!now || now->preset.keyMap.object != (size == 1 ? "a/{note}" : "b/{note}"))
                whole = false;
        }
    };
    std::thread other([&] { hammer(b); });
    hammer(a);
    other.join();
    stop = true;
    audio.join();
    CHECK(finite);
    CHECK(whole);
}

TEST_CASE(
    "A restored factory preset is the current program, and another sound is not taken for it") {
    Processor first, second;
    REQUIRE(first.getNumPrograms() > 1);
    first.setCurrentProgram(1);
    restoreBytes(second, saved(first));
    CHECK(second.getCurrentProgram() == 1);
    CHECK(second.view().presets.playingPreset().id == factoryPresetId(factoryPresets()[1].name));
    restore(second, testState());
    CHECK(second.view().presets.playingPreset().id.empty());
    CHECK(second.getCurrentProgram() == 0); // hosts know no other program
}
