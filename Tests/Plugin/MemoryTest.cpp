// Small files that need much memory are refused with one sentence, and the current sound plays on.
#include "Plugin/RealTimeTrap.h"
#include "Plugin/RestoredSound.h"
#include "Support/ImportedFiles.h"
#include "Support/UserSettings.h"

#include "Editor/ObjectView.h"
#include "Plugin/PresetObjects.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr std::size_t manyModes = 20'000; // the tables take 2.56 MB, the file a tenth of it
constexpr std::size_t maximumBytes = 2'000'000;

ModalObject objectOf(std::size_t modes) {
    std::vector<double> frequenciesHz(modes);
    for (std::size_t mode = 0; mode < modes; ++mode)
        frequenciesHz[mode] = 100 + 0.5 * static_cast<double>(mode);
    auto object = syntheticObject(frequenciesHz, std::vector<float>(modes, 0.01f));
    object.name = "Crowd";
    return object;
}

State crowd(KeyMapKind kind, int lowestNote, int highestNote) {
    auto state = testState();
    state.preset.name = "Crowded";
    state.preset.keyMap = {
        .kind = kind, .lowestNote = lowestNote, .highestNote = highestNote, .object = "crowd"};
    state.objects = {{.name = "crowd", .modal = encodeModalObject(objectOf(manyModes))}};
    return state;
}

void restoreTest(Processor& processor) {
    restore(processor, testState());
    processor.prepareToPlay(48000, blockSamples);
    REQUIRE_FALSE(processor.view().status.takeStatus().isError);
}

/// Checks that the sound of `restoreTest` plays on and is saved, and that the status says why.
void checkKept(Processor& processor, const std::string& sentence) {
    const auto status = processor.view().status.takeStatus();
    CHECK(status.isError);
    CHECK_THAT(status.sentence, ContainsSubstring(sentence));
    CHECK(processor.soundSession().loadedSound().preset.name == "Test keyboard");
    CHECK(saved(processor) == encodeState(testState()));
    CHECK(loudest(firstBlock(processor)) > 1e-4f);
}

const std::string noMemory = " takes more memory than this machine has";

} // namespace

TEST_CASE("An object with many modes on many keys is refused, and the current sound plays on") {
    const UserSettings user;
    Processor processor;
    restoreTest(processor);
    const std::string fault = "has 2560000 modes on all keys together";
    SECTION("in a small state") {
        for (const auto kind : {KeyMapKind::scaled, KeyMapKind::bars}) {
            const auto bytes = encodeState(crowd(kind, 0, 127));
            CHECK(bytes.size() < 2'000'000);
            restoreBytes(processor, bytes);
            checkKept(processor, "The saved state cannot be played: 'crowd' " + fault);
        }
    }
    SECTION("in a preset") {
        user.write("Presets/Crowd.json",
                   R"({"format":"idiophone-preset","version":1,"name":"Crowded","keyMap":{"kind":)"
                   R"("scaled","lowestNote":0,"highestNote":127,"object":"crowd.modal"}})");
        REQUIRE(writeModalObject(objectOf(manyModes), user.folder() / "Presets/crowd.modal"));
        const auto loaded = processor.view().presets.loadPreset("Crowd.json");
        REQUIRE_FALSE(loaded);
        CHECK_THAT(loaded.error().message, ContainsSubstring("Crowded cannot be played: 'crowd"));
        CHECK_THAT(loaded.error().message, ContainsSubstring(fault));
        processor.view().status.reportError(loaded.error().message);
        checkKept(processor, fault);
    }
    SECTION("opened in the window, for a key map with as many modes") {
        const auto file = testFolder() / "Crowd.modal";
        REQUIRE(writeModalObject(objectOf(maximumObjectModes), file));
        processor.view().workshop.openFile(file);
        finish(processor);
        checkKept(processor, "Crowd cannot be played: 'imported/Crowd");
    }
    SECTION("not refused where one bank plays all keys") {
        restore(processor, crowd(KeyMapKind::zones, 0, 127));
        CHECK_FALSE(processor.view().status.takeStatus().isError);
        CHECK(processor.soundSession().loadedSound().preset.name == "Crowded");
        processor.view().workshop.setKeyLayout(KeyLayout::scaled);
        CHECK_THAT(processor.view().status.takeStatus().sentence,
                   ContainsSubstring("The keys cannot be changed: 'crowd' " + fault));
        CHECK(processor.view().workshop.keyLayout() == KeyLayout::zones);
    }
}

TEST_CASE("A sound that needs too much memory is refused, and the current sound plays on") {
    if (!realTimeTrapWorks())
        SKIP("allocations cannot be made to fail here");
    const UserSettings user;
    Processor processor;
    const auto bytes = encodeState(crowd(KeyMapKind::zones, 60, 72));
    SECTION("of a state") {
        restoreTest(processor);
        {
            const MemoryLimit limit(maximumBytes);
            restoreBytes(processor, bytes);
        }
        checkKept(processor, "Crowded" + noMemory);
        restoreBytes(processor, bytes);
        CHECK_FALSE(processor.view().status.takeStatus().isError);
        CHECK(processor.soundSession().loadedSound().preset.name == "Crowded");
    }
    SECTION("of a state that cannot even be read") {
        restoreTest(processor);
        {
            const MemoryLimit limit(100'000);
            restoreBytes(processor, bytes);
        }
        checkKept(processor, "The saved state" + noMemory);
    }
    SECTION("of a preset") {
        user.write("Presets/Crowd.json",
                   R"({"format":"idiophone-preset","version":1,"name":"Crowded","keyMap":{"kind":)"
                   R"("zones","lowestNote":0,"highestNote":127,"object":"crowd.modal"}})");
        REQUIRE(writeModalObject(objectOf(manyModes), user.folder() / "Presets/crowd.modal"));
        restoreTest(processor);
        {
            const MemoryLimit limit(maximumBytes);
            REQUIRE(processor.view().presets.loadPreset("Crowd.json"));
        }
        checkKept(processor, "Crowded" + noMemory);
        CHECK_FALSE(processor.windowSession().history.canUndo());
        {
            const MemoryLimit limit(100'000);
            const auto loaded = processor.view().presets.loadPreset("Crowd.json");
            REQUIRE_FALSE(loaded);
            CHECK_THAT(loaded.error().message, ContainsSubstring("Crowded cannot be played: "));
            CHECK_THAT(loaded.error().message, ContainsSubstring("too large for this machine"));
        }
    }
    SECTION("of an opened object") {
        const auto file = testFolder() / "Crowd.modal";
        REQUIRE(writeModalObject(objectOf(2000), file)); // on 61 keys
        for (const int most : {200'000, 20'000}) {
            restoreTest(processor);
            processor.view().workshop.openFile(file);
            {
                const MemoryLimit limit(static_cast<std::size_t>(most));
                finish(processor);
            }
            checkKept(processor, noMemory);
        }
    }
    SECTION("when the host prepares") {
        restoreBytes(processor, bytes);
        CHECK_FALSE(processor.view().status.takeStatus().isError);
        {
            const MemoryLimit limit(maximumBytes);
            processor.prepareToPlay(48000, blockSamples);
        }
        CHECK(processor.view().status.takeStatus().sentence == "Crowded" + noMemory);
        CHECK(loudest(firstBlock(processor)) == 0);
        CHECK(saved(processor) == bytes);
        processor.prepareToPlay(48000, blockSamples);
        CHECK(loudest(firstBlock(processor)) > 1e-4f);
    }
}

TEST_CASE("A picture that needs too much memory is not drawn, and the current sound plays on") {
    if (!realTimeTrapWorks())
        SKIP("allocations cannot be made to fail here");
    const UserSettings user;
    Processor processor;
    restoreTest(processor);
    ObjectView view(processor.view());
    view.setSize(300, 300);
    auto object = syntheticObject({440});
    for (int face = 0; face < 100'000; ++face)
        object.faces.insert(object.faces.end(), {0, 1, 2});
    auto state = crowd(KeyMapKind::zones, 60, 72);
    state.objects = {{.name = "crowd", .modal = encodeModalObject(object)}};
    restore(processor, state);
    REQUIRE_FALSE(processor.view().status.takeStatus().isError);
    {
        const MemoryLimit limit(maximumBytes);
        view.refresh();
    }
    CHECK_FALSE(view.strikeAt({150, 150}));
    CHECK(loudest(firstBlock(processor)) > 1e-4f);
    state.preset.keyMap.highestNote = 71;
    restore(processor, state);
    view.refresh();
    CHECK(view.strikeAt({150, 150}));
}
