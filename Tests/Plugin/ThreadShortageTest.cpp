// If the system starts no more threads, requests that need one are refused with one sentence, and
// the current sound plays on.
#include "Plugin/RealTimeTrap.h"
#include "Plugin/RestoredSound.h"
#include "Support/ImportedFiles.h"
#include "Support/RecordedStrike.h"
#include "Support/UserSettings.h"

#include "Instrument/FactoryContent.h"
#include "Plugin/WithinMemory.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <system_error>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;

namespace {

const std::string noThread = " needs a thread, and this machine starts no more";

int programOnAStage() {
    const auto presets = factoryPresets();
    const auto found = std::ranges::find_if(
        presets, [](const Preset& preset) { return preset.keyMap.kind == KeyMapKind::scene; });
    REQUIRE(found != presets.end());
    return static_cast<int>(found - presets.begin());
}

} // namespace

TEST_CASE("A system error is reported in one sentence that names its subject") {
    const auto sentence = [](std::errc fault) {
        return withinMemory(
                   [=]() -> Result<void> { throw std::system_error(std::make_error_code(fault)); },
                   "Bell")
            .error()
            .message;
    };
    CHECK(sentence(std::errc::resource_unavailable_try_again) == "Bell" + noThread);
    CHECK_THAT(sentence(std::errc::permission_denied), ContainsSubstring("Bell cannot be made: "));
}

TEST_CASE("A scene without a thread for its bodies is refused, and the current sound plays on") {
    if (!realTimeTrapWorks())
        SKIP("threads cannot be made to fail here");
    const UserSettings user;
    const int stage = programOnAStage();
    Processor processor;
    SECTION("as a program") {
        restore(processor, testState());
        processor.prepareToPlay(48000, blockSamples);
        {
            const NoThreads shortage;
            processor.setCurrentProgram(stage);
        }
        const auto status = processor.view().status.takeStatus();
        CHECK(status.isError);
        CHECK_THAT(status.sentence, ContainsSubstring(noThread));
        CHECK(processor.soundSession().loadedSound().preset.name == "Test keyboard");
        CHECK(loudest(firstBlock(processor)) > 1e-4f);
    }
    SECTION("in a state") {
        processor.setCurrentProgram(stage);
        const auto bytes = saved(processor);
        restore(processor, testState());
        processor.prepareToPlay(48000, blockSamples);
        {
            const NoThreads shortage;
            restoreBytes(processor, bytes);
        }
        CHECK_THAT(processor.view().status.takeStatus().sentence, ContainsSubstring(noThread));
        CHECK(processor.soundSession().loadedSound().preset.name == "Test keyboard");
    }
    SECTION("when the host prepares") {
        processor.setCurrentProgram(stage);
        {
            const NoThreads shortage;
            processor.prepareToPlay(48000, blockSamples);
        }
        CHECK_THAT(processor.view().status.takeStatus().sentence, ContainsSubstring(noThread));
        CHECK(loudest(firstBlock(processor)) == 0);
    }
    processor.prepareToPlay(48000, blockSamples);
    processor.setCurrentProgram(stage);
    CHECK_FALSE(processor.view().status.takeStatus().isError);
}

TEST_CASE("Without a thread to read it, a file is refused; later the same file opens") {
    if (!realTimeTrapWorks())
        SKIP("threads cannot be made to fail here");
    const UserSettings user;
    const auto file = smallPlateFile("plate.obj", 1000);
    Processor processor;
    restore(processor, testState());
    processor.prepareToPlay(48000, blockSamples);
    {
        const NoThreads shortage;
        processor.view().workshop.openFile(file);
    }
    CHECK(processor.view().workshop.importStatus().stage == ImportStatus::Stage::failed);
    finish(processor);
    const auto status = processor.view().status.takeStatus();
    CHECK(status.isError);
    CHECK(status.sentence == "plate.obj" + noThread);
    CHECK(processor.soundSession().loadedSound().preset.name == "Test keyboard");
    CHECK(loudest(firstBlock(processor)) > 1e-4f);
    processor.view().workshop.openFile(file);
    finish(processor);
    CHECK(processor.soundSession().loadedSound().preset.name == "plate");
}

TEST_CASE("Without a thread to fit a material, the recording is refused; later it is fitted") {
    if (!realTimeTrapWorks())
        SKIP("threads cannot be made to fail here");
    const UserSettings user;
    const RecordedStrike strike{.recording = recordedStrike("strike.wav", {{440, 6, 0.4}})};
    Processor processor;
    auto& fits = processor.view().materialFits;
    {
        const NoThreads shortage;
        fits.fitMaterial(strike);
    }
    processor.poll();
    CHECK(processor.view().status.takeStatus().sentence == "strike.wav" + noThread);
    fits.fitMaterial(strike);
    waitUntil([&] { return fits.fitStatus().stage != MaterialFitStatus::Stage::working; },
              [&] { processor.poll(); });
    CHECK(fits.fitStatus().stage == MaterialFitStatus::Stage::done);
}
