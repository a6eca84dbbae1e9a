// A dropped object plays at once, is as loud as the presets, and is saved in the state.
#include "Support/ImportedFiles.h"
#include "Support/TestSound.h"

#include "Instrument/FactoryContent.h"
#include "Instrument/SingleObjectMap.h"
#include "Object/ModalObjectFile.h"
#include "Plugin/FactoryPrograms.h"

#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <functional>
#include <thread>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;
using ImportStage = ImportStatus::Stage;

namespace {

void open(Processor& processor, const std::filesystem::path& file) {
    processor.view().workshop.openFile(file);
    finish(processor);
    INFO(processor.view().workshop.importStatus().error);
    REQUIRE(processor.view().workshop.importStatus().stage == ImportStage::done);
}

float impact(Processor& processor, int note, int velocity = 100) {
    processor.reset();
    juce::MidiBuffer midi;
    midi.addEvent(juce::MidiMessage::noteOn(1, note, static_cast<juce::uint8>(velocity)), 10);
    return loudest(render(processor, 24000, testBlockSize, midi));
}

double lowestHz(const SynthesiserSlot& slot) {
    return std::sqrt(slot.object->eigenvalues.front()) / 6.283185307179586 / slot.sizeRatio;
}

std::size_t slotOf(const Instrument& instrument, int note) {
    return static_cast<std::size_t>(instrument.key(note).slot);
}

} // namespace

TEST_CASE("A dropped mesh plays at the pitches of the keys, from the preview on") {
    Processor processor;
    processor.prepareToPlay(48000, testBlockSize);
    const auto before = processor.soundSession().instrument();
    processor.view().workshop.openFile(smallPlateFile("plate.obj", 1));
    CHECK(processor.soundSession().instrument() == before);
    int played = 0;
    auto last = before;
    finish(processor, [&] {
        const auto now = processor.soundSession().instrument();
        if (now == last)
            return;
        last = now;
        ++played;
        for (const int note : {36, 60, 96}) {
            const double hz = 440 * std::exp2((note - 69) / 12.0);
            CHECK(std::abs(lowestHz(now->slots()[slotOf(*now, note)]) / hz - 1) < 0.01);
        }
        CHECK(impact(processor, 60) > 0.003f);
    });
    CHECK(played >= 1);
    CHECK(processor.view().workshop.importStatus().stage == ImportStage::done);
    CHECK(processor.view().workshop.keyLayout() == KeyLayout::scaled);
    CHECK(processor.view().instrument.keyRange().lowest == 36);
    CHECK(processor.view().instrument.keyRange().highest == 96);
    CHECK(processor.view().instrument.playedObjects().size() == 1);
    CHECK_THAT(processor.view().status.takeStatus().sentence, ContainsSubstring("plate: "));
}

TEST_CASE("The former sound plays until the object is ready, and nothing clicks") {
    Processor processor;
    restore(processor, testState());
    processor.prepareToPlay(48000, testBlockSize);
    juce::MidiBuffer chord;
    for (const int note : {60, 64, 67})
        chord.addEvent(juce::MidiMessage::noteOn(1, note, static_cast<juce::uint8>(100)), 0);
    const auto stepOf = [](const std::vector<float>& samples) {
        float largest = 0;
        for (std::size_t i = 2; i < samples.size(); ++i)
            largest = std::max(largest, std::abs(samples[i] - 2 * samples[i - 1] + samples[i - 2]));
        return largest;
    };
    const auto ringing = render(processor, 4800, testBlockSize, chord).left;
    const float steepest = stepOf(ringing);
    REQUIRE(steepest > 0);
    processor.view().workshop.openFile(smallPlateFile("plate.obj", 1));
    std::vector<float> heard;
    const auto load = processor.view().instrument.instrumentNumber();
    finish(processor, [&] {
        const auto block = render(processor, testBlockSize, testBlockSize, {}).left;
        if (processor.view().instrument.instrumentNumber() == load) {
            // Strike again, so that the change happens during sound.
            if (loudest(block) < 0.1f * loudest(ringing))
                render(processor, testBlockSize, testBlockSize, chord);
        } else {
            heard.insert(heard.end(), block.begin(), block.end());
        }
    });
    CHECK(stepOf(heard) <= steepest);
    CHECK(processor.view().workshop.importStatus().stage == ImportStage::done);
}

TEST_CASE("Dropped objects of any size and kind are audible and do not clip") {
    const std::vector<std::pair<std::string, Mesh>> things{{"plate", sheetMesh(0.08, 0.05, 150)},
                                                           {"hoop", hoopMesh(0.03, 0.01, 40, 3)},
                                                           {"ball", icosphereMesh(0.05, 2)},
                                                           {"coin", discMesh(0.012, 6)}};
    for (const auto& [name, mesh] : things) {
        Processor processor;
        processor.prepareToPlay(48000, testBlockSize);
        open(processor, meshFile(name + ".obj", mesh));
        for (const auto layout : {KeyLayout::scaled, KeyLayout::zones}) {
            processor.view().workshop.setKeyLayout(layout);
            float loudestKey = 0;
            for (int note = 36; note <= 96; note += 6)
                loudestKey = std::max(loudestKey, impact(processor, note, 127));
            INFO(name << ", layout " << static_cast<int>(layout) << ", level "
                      << processor.view().parameters.value(ParameterId::level) << " dB");
            CHECK(loudestKey < 1);
            // At its own size the ball vibrates only above the hearing range.
            const bool isAudible = name != "ball" || layout == KeyLayout::scaled;
            if (isAudible)
                CHECK(loudestKey > 0.01f);
        }
    }
}

TEST_CASE(
    "Undo of a key layout during a preview keeps the analysis, and redo plays its final object") {
    Processor processor;
    processor.prepareToPlay(48000, testBlockSize);
    processor.view().workshop.openFile(meshFile("ball.obj", icosphereMesh(0.05, 3)));
    bool switched = false;
    finish(processor, [&] {
        const auto status = processor.view().workshop.importStatus();
        if (switched || !status.isWorking() ||
            processor.view().workshop.keyLayout() != KeyLayout::scaled)
            return;
        switched = true;
        processor.view().workshop.setKeyLayout(KeyLayout::zones);
        processor.windowSession().history.undo();
        CHECK(processor.view().workshop.keyLayout() == KeyLayout::scaled);
    });
    REQUIRE(switched);
    CHECK(processor.view().workshop.importStatus().stage == ImportStage::done);
    const auto whole = processor.soundSession().instrument()->slots().front().object;
    CHECK(whole->provenance.notes.find("preview") == std::string::npos);
    processor.windowSession().history.redo();
    CHECK(processor.view().workshop.keyLayout() == KeyLayout::zones);
    CHECK(processor.soundSession().instrument()->slots().front().object == whole);
    processor.windowSession().history.undo();
    CHECK(processor.view().workshop.keyLayout() == KeyLayout::scaled);
    CHECK(processor.soundSession().instrument()->slots().front().object == whole);
}

TEST_CASE("A file that cannot be opened changes nothing and gives an error in the window") {
    Processor processor;
    restore(processor, testState());
    const auto before = saved(processor);
    processor.view().workshop.openFile(writtenFile("broken.stl", "solid nothing"));
    finish(processor);
    CHECK(processor.view().workshop.importStatus().stage == ImportStage::failed);
    CHECK(saved(processor) == before);
    const auto status = processor.view().status.takeStatus();
    CHECK(status.isError);
    CHECK_THAT(status.sentence, ContainsSubstring("\"broken.stl\""));
    CHECK(processor.view().workshop.canOpen("a.OBJ"));
    CHECK(processor.view().workshop.canOpen("a.modal"));
    CHECK_FALSE(processor.view().workshop.canOpen("a.mp3"));
    CHECK_FALSE(processor.view().workshop.canOpen("obj"));
}

TEST_CASE("After a file that cannot be opened, the window shows the object that plays") {
    Processor processor;
    REQUIRE(processor.view().presets.loadPreset(factoryPresetId("Steel Ring")));
    processor.view().workshop.openFile(writtenFile("broken.stl", "solid nothing"));
    finish(processor);
    const auto status = processor.view().workshop.importStatus();
    const auto& ring = *processor.soundSession().instrument()->slots().front().object;
    CHECK(status.stage == ImportStage::failed);
    CHECK(status.fileName == ring.name);
    CHECK(status.massKg == ring.mass.massKg);
}

TEST_CASE("A state of a dropped object opens without its file, bit for bit") {
    Processor first, second;
    const auto file = smallPlateFile("plate.obj", 1);
    open(first, file);
    first.view().workshop.setKeyLayout(KeyLayout::zones);
    first.view().workshop.setStrikePath(0, {{-0.015, -0.006, 0}, {0, 0.009, 0}, {0.02, 0.003, 0}});
    const auto bytes = saved(first);
    std::filesystem::remove(file);
    restoreBytes(second, bytes);
    CHECK_FALSE(second.view().status.takeStatus().isError);
    CHECK(saved(second) == bytes);
    first.prepareToPlay(48000, testBlockSize);
    second.prepareToPlay(48000, testBlockSize);
    juce::MidiBuffer midi;
    midi.addEvent(juce::MidiMessage::noteOn(1, 50, static_cast<juce::uint8>(100)), 10);
    const auto heard = render(first, 4800, testBlockSize, midi);
    CHECK(loudest(heard) > 0.001f);
    CHECK(render(second, 4800, testBlockSize, midi) == heard);
    CHECK(second.view().workshop.keyLayout() == KeyLayout::zones);
    // The restored object can be analysed again from its own mesh.
    REQUIRE(second.view().workshop.canAnalyseAgain());
    CHECK_FALSE(second.view().workshop.importStatus().followsSettings);
    second.view().workshop.setImportSettings({.material = "Copper", .thicknessMetres = 0.003});
    CHECK_FALSE(second.view().workshop.importStatus().isWorking());
    second.view().workshop.analyseAgain();
    finish(second);
    CHECK(second.view().workshop.importStatus().stage == ImportStage::done);
    CHECK(second.view().instrument.playedObjects().front().object->material.name == "Copper");
    CHECK(second.view().workshop.keyLayout() == KeyLayout::zones);
}

TEST_CASE("Changed settings analyse the same mesh again at once") {
    Processor processor;
    const auto file = smallPlateFile("plate.obj", 1);
    open(processor, file);
    std::filesystem::remove(file);
    processor.view().workshop.setKeyLayout(KeyLayout::zones);
    REQUIRE(processor.view().workshop.importStatus().followsSettings);
    processor.view().workshop.setImportSettings({.material = "Glass", .thicknessMetres = 0.004});
    finish(processor);
    CHECK(processor.view().workshop.importStatus().stage == ImportStage::done);
    CHECK(processor.view().workshop.importStatus().settings.material == "Glass");
    CHECK(processor.view().instrument.playedObjects().front().object->material.name == "Glass");
    CHECK(processor.view().instrument.playedObjects().front().object->thicknessMetres == 0.004);
    CHECK(processor.view().workshop.keyLayout() == KeyLayout::zones);
}

TEST_CASE("An object without an imported mesh is analysed again with its own settings") {
    Processor first, processor;
    first.view().workshop.setImportSettings({.material = "Copper", .thicknessMetres = 0.004});
    open(first, smallPlateFile("plate.obj", 1));
    const auto copper = first.view().instrument.playedObjects().front().object;
    const auto file = testFolder() / "copper.modal";
    REQUIRE(writeModalObject(*copper, file));

    open(processor, file);
    finish(processor);
    const auto settings = processor.view().workshop.importStatus().settings;
    CHECK(settings.material == "Copper");
    CHECK(settings.thicknessMetres == copper->thicknessMetres);
    processor.view().parameters.change(ParameterId::material, firstLibraryMaterial + 4);
    const auto glass = saved(processor);
    processor.view().workshop.setImportSettings({.material = "Brass", .thicknessMetres = 0.001});
    CHECK(processor.view().workshop.importStatus().settings.material == "Brass");
    processor.view().workshop.setKeyLayout(KeyLayout::zones);
    CHECK(processor.view().workshop.importStatus().settings.material == "Brass");
    restoreBytes(processor, glass);
    finish(processor);
    CHECK(processor.view().workshop.importStatus().settings.material == "Glass");
    processor.view().workshop.analyseAgain();
    finish(processor);
    const auto again = processor.view().instrument.playedObjects().front().object;
    CHECK(again->material.name == "Glass");
    CHECK(again->thicknessMetres == copper->thicknessMetres);
}

TEST_CASE("A mesh opens with the given settings, whatever plays") {
    Processor processor;
    REQUIRE(processor.view().presets.loadPreset(factoryPresetId("Wooden Table")));
    const auto table = processor.view().workshop.importStatus().settings;
    CHECK(table.material == "Wood");
    open(processor, smallPlateFile("plate.obj", 1));
    const auto& plate = *processor.view().instrument.playedObjects().front().object;
    CHECK(plate.material.name == ImportSettings{}.material);
    CHECK(plate.thicknessMetres == ImportSettings{}.thicknessMetres);
    CHECK(processor.view().workshop.importStatus().settings == ImportSettings{});
}

TEST_CASE("The import status of a file is shown only while that file plays") {
    Processor processor;
    open(processor, smallPlateFile("plate.obj", 1));
    CHECK(processor.view().workshop.importStatus().fileName == "plate.obj");
    processor.setCurrentProgram(0);
    CHECK(processor.view().workshop.importStatus().stage == ImportStage::none);
    CHECK(processor.view().workshop.importStatus().fileName.empty());
    open(processor, smallPlateFile("other.obj", 1));
    processor.windowSession().history.undo();
    CHECK(processor.view().workshop.importStatus().stage == ImportStage::none);
    processor.windowSession().history.redo();
    CHECK(processor.view().workshop.importStatus().stage == ImportStage::done);
    CHECK(processor.view().workshop.importStatus().fileName == "other.obj");
}

TEST_CASE("Keys strike along a path drawn by hand") {
    Processor processor;
    processor.prepareToPlay(48000, testBlockSize);
    open(processor, smallPlateFile("plate.obj", 1));
    const auto strikePath = [&] {
        const auto playing = processor.soundSession().instrument();
        return pathMetres(*playing->slots().front().object, playing->keyMap());
    };
    const auto own = strikePath();
    REQUIRE(own.size() > 1);
    CHECK(own.front()[0] < -0.027);
    CHECK(own.back()[0] > 0.027);
    const std::vector<std::array<double, 3>> drawn{{-0.01, 0.015, 0}, {0.006, -0.012, 0}};
    processor.view().workshop.setStrikePath(0, drawn);
    const auto path = strikePath();
    REQUIRE(path.size() == 2);
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            CHECK(std::abs(path[i][axis] - drawn[i][axis]) < 1e-6);

    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    processor.view().workshop.setStrikePath(0, {});
    processor.view().workshop.setStrikePath(0, {{nan, 0, 0}});
    processor.view().workshop.setStrikePath(7, drawn);
    CHECK(strikePath() == path);
    processor.view().workshop.setStrikePath(0, {{9, 9, 9}});
    CHECK(strikePath().size() == 1);
    CHECK(impact(processor, 60) > 0.001f);
    processor.view().workshop.setStrikePath(
        0, std::vector<std::array<double, 3>>(5000, {0.01, 0.01, 0}));
    CHECK(strikePath().size() == 1000);
}

TEST_CASE("An import keeps the mallet, and the material becomes the object's own") {
    Processor processor;
    auto state = testState();
    state.parameters.set(ParameterId::mallet, firstRackMallet + 3);
    state.parameters.set(ParameterId::material, firstLibraryMaterial + 2);
    state.parameters.set(ParameterId::releaseTime, 0.321);
    restore(processor, state);
    open(processor, smallPlateFile("plate.obj", 1));
    CHECK(processor.view().parameters.value(ParameterId::mallet) == firstRackMallet + 3);
    CHECK(processor.view().parameters.value(ParameterId::releaseTime) == 0.321);
    CHECK(static_cast<int>(processor.view().parameters.value(ParameterId::material)) ==
          ownMaterial);
    processor.view().parameters.change(ParameterId::material, customMaterial);
    processor.view().workshop.setKeyLayout(KeyLayout::zones);
    CHECK(static_cast<int>(processor.view().parameters.value(ParameterId::material)) ==
          customMaterial);
}

TEST_CASE("A preset chosen during an import is kept") {
    Processor processor;
    processor.view().workshop.openFile(smallPlateFile("plate.obj", 1));
    processor.setCurrentProgram(4);
    const auto chosen = processor.soundSession().instrument();
    finish(processor);
    CHECK(processor.soundSession().instrument() == chosen);
    CHECK(processor.view().workshop.importStatus().stage != ImportStage::done);
    CHECK(processor.getCurrentProgram() == 4);
    CHECK(processor.view().workshop.keyLayout() == KeyLayout::scaled);
    processor.setCurrentProgram(0);
    CHECK_FALSE(processor.view().workshop.keyLayout());
    processor.view().workshop.setKeyLayout(KeyLayout::zones);
    CHECK(processor.getCurrentProgram() == 0);
    CHECK_FALSE(processor.view().workshop.canAnalyseAgain());
}

TEST_CASE("A processor can be destroyed while its workshop works, without a message loop") {
    const auto file = meshFile("ball.obj", icosphereMesh(0.1, 4));
    for (const double progress : {0.0, 0.01, 0.1}) { // 0.1 is in the preview
        Processor processor;
        processor.prepareToPlay(48000, testBlockSize);
        processor.view().workshop.openFile(file);
        waitUntil([&] { return processor.view().workshop.importStatus().progress >= progress; });
        CHECK(allFinite(render(processor, 4800, testBlockSize, testMusic(4800))));
        CHECK(processor.engineReport().notFinite == 0);
        processor.releaseResources();
        processor.prepareToPlay(44100, 64);
        saved(processor);
    }
}

TEST_CASE("A state that the host loads during an import is not replaced by the imported object") {
    const auto file = smallPlateFile("raced.obj", 1);
    const auto bytes = encodeState(testState());
    for (int part = 0; part < 10; ++part) {
        INFO("after " << part << " tenths of the import");
        Processor processor;
        processor.prepareToPlay(48000, testBlockSize);
        processor.view().workshop.openFile(file);
        std::atomic<bool> isDue{false}, isRestored{false};
        std::thread host([&] {
            isDue.wait(false);
            restoreBytes(processor, bytes);
            isRestored = true;
        });
        waitUntil([&] { return isRestored.load(); },
                  [&] {
                      const auto status = processor.view().workshop.importStatus();
                      if (!status.isWorking() || status.progress >= part / 10.0) {
                          isDue = true;
                          isDue.notify_all();
                      }
                      processor.poll();
                  });
        host.join();
        waitUntil([&] { return !processor.view().workshop.importStatus().isWorking(); },
                  [&] { processor.poll(); });
        processor.poll();
        CHECK(processor.soundSession().loadedSound().preset.name == "Test keyboard");
        CHECK_FALSE(processor.view().workshop.importStatus().followsSettings);
        CHECK_FALSE(processor.windowSession().history.canUndo());
    }
}

TEST_CASE("Automated values are kept after an import, a change of keys or a mutation") {
    Processor processor;
    processor.prepareToPlay(48000, testBlockSize);
    open(processor, smallPlateFile("automated.obj", 1));
    auto* const automated = processor.getParameters()[static_cast<int>(ParameterId::tune)];
    std::atomic<bool> ends{false};
    std::atomic<int> overwritten{0};
    std::thread host([&] {
        for (int i = 0; !ends; i = (i + 1) % 1000) {
            const auto value = 0.0005f * static_cast<float>(i);
            automated->setValue(value);
            const float sent = automated->getValue();
            for (int look = 0; look < 200; ++look) {
                std::this_thread::yield();
                if (automated->getValue() != sent)
                    ++overwritten;
            }
        }
    });
    const auto stays = [&](const char* what, const std::function<void()>& step) {
        INFO(what);
        step();
        CHECK(processor.windowSession().history.undoName() == what);
        CHECK(overwritten.exchange(0) == 0);
    };
    stays("Open another", [&] { open(processor, smallPlateFile("another.obj", 1)); });
    stays("Analyse another", [&] {
        processor.view().workshop.analyseAgain();
        finish(processor);
    });
    for (int i = 0; i < 6; ++i) {
        stays(i % 2 == 0 ? "Keys along a path" : "Keys at their pitches", [&] {
            processor.view().workshop.setKeyLayout(i % 2 == 0 ? KeyLayout::zones
                                                              : KeyLayout::scaled);
        });
        stays("Mutate", [&] { processor.view().variants.mutate(0.5, 7); });
    }
    ends = true;
    host.join();
}

TEST_CASE("An object opened during an audition keeps playing, and undo returns to the auditioned "
          "preset") {
    Processor processor;
    processor.prepareToPlay(48000, testBlockSize);
    auto& shelf = processor.view().presets;
    REQUIRE(shelf.auditionPreset(factoryPresetId("Wok")));
    open(processor, smallPlateFile("auditioned.obj", 1));
    CHECK(processor.soundSession().loadedSound().preset.name == "auditioned");
    shelf.endAudition();
    CHECK(processor.soundSession().loadedSound().preset.name == "auditioned");
    processor.windowSession().history.undo();
    CHECK(processor.soundSession().loadedSound().preset.name == "Wok");
}
