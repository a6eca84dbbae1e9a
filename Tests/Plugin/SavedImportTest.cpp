// Tests presets and states with dropped objects.
#include "Plugin/PresetsAtHand.h"
#include "Support/ImportedFiles.h"
#include "Support/TestSound.h"
#include "Support/UserSettings.h"

#include "Instrument/ObjectLibrary.h"
#include "Object/ModalObjectFile.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <string>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("A preview cannot be saved in place of the final object") {
    const UserSettings user;
    Processor processor;
    processor.prepareToPlay(48000, testBlockSize);
    processor.view().workshop.openFile(
        meshFile("block.obj", boxMesh({0.3, 0.2, 0.1}, {24, 16, 8})));
    waitUntil([&] { return processor.view().workshop.playsPreview(); },
              [&] {
                  REQUIRE(processor.view().workshop.importStatus().isWorking());
                  processor.poll();
              });
    auto& shelf = processor.view().presets;
    const auto refused = shelf.savePreset(called("Block"), false);
    REQUIRE_FALSE(refused);
    CHECK_THAT(refused.error().message, ContainsSubstring("preview"));
    CHECK_FALSE(shelf.presetExists(called("Block")));
    CHECK_THAT(processor.soundSession().loadedSound().preset.description,
               ContainsSubstring("preview"));
    processor.view().workshop.cancelImport();
    CHECK(shelf.savePreset(called("Block"), false)); // after the cancellation the object is final
}

TEST_CASE("An object with a very long name is saved in a state that opens again") {
    auto object = *ObjectLibrary::shared().find("wok").value();
    object.name = std::string(5000, 'w');
    Processor processor;
    processor.prepareToPlay(48000, testBlockSize);
    const auto file = testFolder() / "long.modal";
    REQUIRE(writeModalObject(object, file));
    processor.view().workshop.openFile(file);
    finish(processor);
    Processor other;
    restoreBytes(other, saved(processor));
    CHECK_FALSE(other.view().status.takeStatus().isError);
    CHECK(other.soundSession().instrument()->slots().front().object->name == object.name);
}
