// The window's export of samples, from the sound that plays to files, and how it ends early.
#include "AudioFiles/AudioFileReader.h"
#include "Object/FileBytes.h"
#include "Object/TextFile.h"
#include "Object/WorkTeam.h"
#include "Plugin/FactoryPrograms.h"
#include "Plugin/Processor.h"
#include "Sampling/SampleFolder.h"
#include "Support/TestFolder.h"
#include "Support/TestSound.h"
#include "Support/WaitUntil.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <fstream>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;
using SampleStage = SampleStatus::Stage;

namespace {

/// Two keys of one layer, cut early.
SampleSettings shortSettings() {
    return {.lowestKey = 60,
            .highestKey = 61,
            .velocities = 1,
            .bitDepth = 16,
            .tailDecibels = -30,
            .longestSeconds = 1};
}

struct Sampled {
    Sampled() {
        restore(processor, testState());
        processor.prepareToPlay(48000, 480);
    }
    SampleStatus wait() {
        waitUntil([&] {
            const auto stage = samples.sampleStatus().stage;
            return stage != SampleStage::estimating && stage != SampleStage::exporting;
        });
        processor.poll();
        return samples.sampleStatus();
    }
    SampleStatus estimate(const SampleSettings& settings) {
        samples.estimateSamples(settings);
        return wait();
    }
    SampleStatus exportTo(const std::filesystem::path& folder, const SampleSettings& settings) {
        samples.exportSamples(settings, folder);
        return wait();
    }
    /// Returns once an export without end is well under way.
    void beginLongExport(const std::filesystem::path& folder) {
        auto settings = shortSettings();
        settings.highestKey = 72;
        settings.velocities = 127;
        settings.tailDecibels = -120;
        settings.longestSeconds = 600;
        samples.exportSamples(settings, folder);
        waitUntil([&] { return std::filesystem::exists(folder / "Test keyboard/samples.json"); });
    }

    Processor processor;
    SampleView& samples = processor.view().samples;
};

std::vector<std::string> namesIn(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const auto& file : std::filesystem::directory_iterator(folder))
        names.push_back(file.path().filename().string());
    std::ranges::sort(names);
    return names;
}

std::string bytesOf(const std::filesystem::path& file) {
    return readBytes(file, 1 << 24).value_or("");
}

} // namespace

TEST_CASE(
    "The sound that plays is exported with its parameters, as the export of the console does") {
    Sampled plugin;
    plugin.processor.view().parameters.changeOnce(ParameterId::decay, 0.5);
    const auto folder = emptyFolder("window");
    const auto status = plugin.exportTo(folder, shortSettings());
    REQUIRE(status.sentence == "");
    REQUIRE(status.stage == SampleStage::done);
    CHECK(status.samples == 2);
    CHECK(status.folder == folder / "Test keyboard");
    CHECK(namesIn(status.folder) == std::vector<std::string>{"060-C4-v127-r1.wav",
                                                             "061-Cs4-v127-r1.wav",
                                                             "Test keyboard.sfz", "samples.json"});

    const auto sound = plugin.processor.soundSession().loadedSound();
    const auto reference = emptyFolder("reference");
    WorkTeam team(1);
    const auto task = taskOfKeys(
        {.instrument = sound.instrument, .preset = sound.preset, .values = sound.parameters},
        std::vector{60, 61}, {.velocities = 1}, ".wav");
    REQUIRE(exportTask(
        task, {.folder = reference, .bitDepth = 16, .tailDecibels = -30, .longestSeconds = 1},
        team));
    for (const auto& name : namesIn(reference)) {
        INFO(name);
        CHECK((bytesOf(status.folder / name) == bytesOf(reference / name)));
    }
}

TEST_CASE("Muted modes and the own tuning are in the samples, and a bypassed sound is not silent") {
    Sampled plugin;
    const auto plain = plugin.exportTo(emptyFolder("plain"), shortSettings());
    const auto sample = [](const SampleStatus& status) {
        return bytesOf(status.folder / "060-C4-v127-r1.wav");
    };
    plugin.processor.view().parameters.changeOnce(ParameterId::bypass, 1);
    CHECK((sample(plugin.exportTo(emptyFolder("bypassed"), shortSettings())) == sample(plain)));
    REQUIRE(plugin.processor.view().sound.muteMode(0, 0, true));
    const auto muted = plugin.exportTo(emptyFolder("muted"), shortSettings());
    CHECK(muted.stage == SampleStage::done);
    CHECK((sample(muted) != sample(plain)));
    const auto scale = testFolder() / "scale.scl";
    std::ofstream(scale) << "Stretched\n1\n1300.\n";
    plugin.processor.view().tuning.openTuning(scale);
    const auto tuned = plugin.exportTo(emptyFolder("tuned"), shortSettings());
    CHECK(tuned.stage == SampleStage::done);
    CHECK((bytesOf(tuned.folder / "061-Cs4-v127-r1.wav") !=
           bytesOf(muted.folder / "061-Cs4-v127-r1.wav")));
}

TEST_CASE("An estimate says how many samples there will be, and follows settings and sound") {
    Sampled plugin;
    auto settings = shortSettings();
    const auto first = plugin.estimate(settings);
    REQUIRE(first.stage == SampleStage::estimated);
    CHECK(first.samples == 2);
    CHECK(first.seconds > 0);
    CHECK(first.megabytes > 0);
    settings.velocities = 3;
    CHECK(plugin.estimate(settings).samples == 6);
    settings.source = SampleSettings::Source::places;
    settings.places = 2;
    settings.object = 1;
    CHECK(plugin.estimate(settings).samples == 6);
    const double before = plugin.estimate(shortSettings()).seconds;
    plugin.processor.view().parameters.changeOnce(ParameterId::decay, 0.3);
    CHECK(plugin.estimate(shortSettings()).seconds < before);
}

TEST_CASE("An interrupted export goes on in the same place, and leaves no incomplete file") {
    Sampled plugin;
    const auto folder = emptyFolder("stopped");
    plugin.beginLongExport(folder);
    CHECK(plugin.samples.sampleStatus().isExporting());
    plugin.samples.estimateSamples(shortSettings()); // does not disturb it
    CHECK(plugin.samples.sampleStatus().isExporting());
    plugin.samples.stopExport();
    CHECK(plugin.samples.sampleStatus().stage == SampleStage::stopped);

    const auto whole = plugin.exportTo(emptyFolder("again"), shortSettings());
    REQUIRE(whole.stage == SampleStage::done);
    const auto lost = whole.folder / "060-C4-v127-r1.wav";
    const auto bytes = bytesOf(lost);
    std::filesystem::remove(lost);
    for (const auto& place : {whole.folder.parent_path(), whole.folder}) {
        const auto again = plugin.exportTo(place, shortSettings());
        CHECK(again.stage == SampleStage::done);
        CHECK(again.folder == whole.folder);
        CHECK((bytesOf(lost) == bytes));
    }
}

TEST_CASE("A plugin that closes while it exports stops at once, without an incomplete file") {
    const auto folder = emptyFolder("closed");
    {
        Sampled plugin;
        plugin.beginLongExport(folder);
    }
    for (const auto& name : namesIn(folder / "Test keyboard")) {
        INFO(name);
        CHECK((name == "samples.json" || readChannels(folder / "Test keyboard" / name)));
    }
}

TEST_CASE("Places of an object lie in a folder of their own, with a table") {
    Sampled plugin;
    auto settings = shortSettings();
    settings.source = SampleSettings::Source::places;
    settings.object = 2;
    settings.places = 2;
    const auto folder = emptyFolder("places");
    const auto status = plugin.exportTo(folder, settings);
    REQUIRE(status.stage == SampleStage::done);
    CHECK(status.samples == 2);
    CHECK(status.folder != folder / "Test keyboard");
    CHECK(namesIn(status.folder) ==
          std::vector<std::string>{"p01-v127.wav", "p02-v127.wav", "samples.csv", "samples.json"});
    settings.object = 0; // another one, which is not mixed with these
    CHECK(plugin.exportTo(folder, settings).folder != status.folder);
    CHECK(plugin.exportTo(status.folder, settings).stage == SampleStage::failed);
}

TEST_CASE("Sounds that samples cannot follow are refused in a sentence") {
    Sampled plugin;
    auto settings = shortSettings();
    const auto refusal = [&] {
        const auto status = plugin.estimate(settings);
        CHECK(status.stage == SampleStage::refused);
        return status.sentence;
    };
    settings.lowestKey = settings.highestKey = 20;
    CHECK(refusal() == "None of these keys plays.");
    settings = shortSettings();
    settings.roundRobins = 2;
    plugin.processor.view().parameters.changeOnce(ParameterId::strikeSpread, 0);
    plugin.processor.view().parameters.changeOnce(ParameterId::chatter, 0);
    CHECK_THAT(refusal(), ContainsSubstring("round robins would sound alike"));
    settings.source = SampleSettings::Source::places;
    settings.places = 1000;
    CHECK_THAT(refusal(), ContainsSubstring("it has mode shapes at only"));
    settings.places = 1;
    settings.object = 99;
    CHECK(refusal() == "This object no longer plays.");
    settings = shortSettings();
    plugin.processor.view().parameters.changeOnce(ParameterId::contact, scrapeContact);
    CHECK_THAT(refusal(), ContainsSubstring("scrapes, rolls or bows"));
    REQUIRE(plugin.processor.view().presets.loadPreset(factoryPresetId("Dice on Rosewood")));
    CHECK_THAT(refusal(), ContainsSubstring("scene"));
}

TEST_CASE("A folder that cannot be written is reported in a sentence") {
    Sampled plugin;
    const auto file = testFolder() / "file";
    std::ofstream(file) << "in the way";
    plugin.samples.exportSamples(shortSettings(), file);
    CHECK_FALSE(plugin.samples.sampleStatus().isExporting());
    CHECK_THAT(plugin.processor.view().status.takeStatus().sentence,
               ContainsSubstring("there can be no folder"));

    const auto folder = emptyFolder("mixed");
    REQUIRE(plugin.exportTo(folder, shortSettings()).stage == SampleStage::done);
    plugin.processor.view().parameters.changeOnce(ParameterId::decay, 0.3);
    const auto failed = plugin.exportTo(folder, shortSettings());
    CHECK(failed.stage == SampleStage::failed);
    CHECK_THAT(failed.sentence, ContainsSubstring("other settings; choose another folder."));
    CHECK(plugin.processor.view().status.takeStatus().sentence == failed.sentence);
}
