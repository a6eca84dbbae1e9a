// Tests when a preset file may be overwritten and when the user has to confirm it.
#include "Plugin/FactoryPrograms.h"
#include "Plugin/PresetsAtHand.h"
#include "Support/TestSound.h"
#include "Support/UserSettings.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;

namespace {

/// While `plays` is false, refuses to play a loaded sound, as if memory ran out.
class ReluctantHolder final : public ForwardingHolder {
public:
    using ForwardingHolder::ForwardingHolder;

    bool playSound(const Sound& sound) override {
        return plays && ForwardingHolder::playSound(sound);
    }

    bool plays = true;
};

} // namespace

TEST_CASE("Overwriting a preset needs confirmation, and setup parameters are not saved") {
    const UserSettings user;
    Processor processor;
    auto& shelf = processor.view().presets;
    REQUIRE(shelf.savePreset(called("Twice"), false));
    CHECK(shelf.presetExists(called("Twice")));
    CHECK_FALSE(shelf.presetExists(called("Thrice")));
    CHECK_FALSE(shelf.presetExists(called("")));
    const auto before = user.read("Presets/Twice.json");
    processor.view().parameters.change(ParameterId::tau, 5);
    processor.view().parameters.change(ParameterId::bypass, 1);
    processor.view().parameters.change(ParameterId::concertPitch, 415);
    const auto refused = shelf.savePreset(called("Twice"), false);
    REQUIRE_FALSE(refused);
    CHECK(user.read("Presets/Twice.json") == before);
    REQUIRE(shelf.savePreset(called("Twice"), true));
    Processor other;
    REQUIRE(other.view().presets.loadPreset("Twice.json"));
    CHECK(other.view().parameters.value(ParameterId::tau) == 5);
    CHECK(other.view().parameters.value(ParameterId::bypass) == 0);
    CHECK(other.view().parameters.value(ParameterId::concertPitch) == 440);
}

TEST_CASE("A preset that another window has saved is not overwritten without confirmation") {
    const UserSettings user;
    using enum ParameterId;
    Processor one, two;
    auto& shelf = one.view().presets;
    auto& otherShelf = two.view().presets;
    REQUIRE(shelf.savePreset(called("Bell"), false));
    REQUIRE(otherShelf.loadPreset("Bell.json"));
    two.view().parameters.change(tau, 5);

    SECTION("the other window changed it") {
        one.view().parameters.change(tau, 3);
        REQUIRE(shelf.saveChosenPreset());
        const auto theirs = user.read("Presets/Bell.json");
        switch (GENERATE(0, 1, 2)) {
        case 0: // before this list is read again
            break;
        case 1: // after this list is read again
            otherShelf.readPresets();
            break;
        default: // after an audition
            REQUIRE(otherShelf.auditionPreset("Bell.json"));
            otherShelf.endAudition();
            CHECK(two.view().parameters.value(tau) == 5);
        }
        const auto refused = otherShelf.saveChosenPreset();
        REQUIRE_FALSE(refused);
        CHECK_THAT(refused.error().message, ContainsSubstring("changed elsewhere"));
        CHECK(user.read("Presets/Bell.json") == theirs);
        // A rename does not lift the refusal.
        REQUIRE(otherShelf.renamePreset("Bell.json", "Gong"));
        CHECK_FALSE(otherShelf.saveChosenPreset());
        // A confirmation, a load or a kept audition lifts the refusal.
        switch (GENERATE(0, 1, 2)) {
        case 0:
            REQUIRE(otherShelf.savePreset(called("Gong"), true));
            break;
        case 1:
            REQUIRE(otherShelf.loadPreset("Gong.json"));
            CHECK(two.view().parameters.value(tau) == 3);
            break;
        default:
            REQUIRE(otherShelf.auditionPreset("Gong.json"));
            otherShelf.keepAudition();
        }
        two.view().parameters.change(tau, 7);
        REQUIRE(otherShelf.saveChosenPreset());
    }
    SECTION("the other window renamed it") {
        REQUIRE(shelf.renamePreset("Bell.json", "Gong"));
        const auto refused = otherShelf.saveChosenPreset();
        REQUIRE_FALSE(refused);
        CHECK_THAT(refused.error().message, ContainsSubstring("Save as"));
        CHECK_FALSE(std::filesystem::exists(user.folder() / "Presets/Bell.json"));
        CHECK(find(otherShelf, "Bell") == nullptr); // so that Save asks for a name from now on
    }
    SECTION("this window saves it twice") {
        REQUIRE(otherShelf.saveChosenPreset());
        two.view().parameters.change(tau, 7);
        REQUIRE(otherShelf.saveChosenPreset());
        REQUIRE(otherShelf.renamePreset("Bell.json", "Gong"));
        two.view().parameters.change(tau, 5);
        REQUIRE(otherShelf.saveChosenPreset());
    }
}

TEST_CASE("A save overwrites only the file version that the current sound came from") {
    const UserSettings user;
    using enum ParameterId;
    Processor one, two;
    auto& shelf = one.view().presets;
    auto& otherShelf = two.view().presets;
    REQUIRE(shelf.savePreset(called("Bell"), false));
    // The value changes the file's size, so that a list notices it at any clock resolution.
    std::string theirs;
    const auto saveTheirs = [&] {
        one.view().parameters.change(tau, 3.0625);
        REQUIRE(shelf.saveChosenPreset());
        theirs = user.read("Presets/Bell.json");
    };
    const auto checkRefused = [&] {
        for (int time = 0; time < 2; ++time) {
            const auto refused = otherShelf.saveChosenPreset();
            REQUIRE_FALSE(refused);
            CHECK_THAT(refused.error().message, ContainsSubstring("changed elsewhere"));
            CHECK(user.read("Presets/Bell.json") == theirs);
        }
    };
    const auto checkSaved = [&](double wanted) {
        two.view().parameters.change(tau, wanted);
        REQUIRE(otherShelf.saveChosenPreset());
        Processor third;
        REQUIRE(third.view().presets.loadPreset(otherShelf.playingPreset().id));
        CHECK(third.view().parameters.value(tau) == wanted);
    };

    SECTION("after an undo") {
        REQUIRE(otherShelf.loadPreset("Bell.json"));
        two.view().parameters.change(tau, 5);
        saveTheirs();
        checkRefused();
        REQUIRE(otherShelf.loadPreset("Bell.json"));
        CHECK(two.view().parameters.value(tau) == 3.0625);
        two.windowSession().history.undo();
        CHECK(two.view().parameters.value(tau) == 5);
        checkRefused();
        two.windowSession().history.redo();
        checkSaved(7);
        // The file now has the other window's change, which the older sound lacks.
        theirs = user.read("Presets/Bell.json");
        two.windowSession().history.undo();
        checkRefused();
    }
    SECTION("after a comparison") {
        REQUIRE(otherShelf.loadPreset("Bell.json"));
        two.view().variants.copyToOther();
        saveTheirs();
        otherShelf.readPresets();
        REQUIRE(otherShelf.loadPreset("Bell.json"));
        two.view().variants.compare();
        checkRefused();
        two.view().variants.compare();
        checkSaved(7);
    }
    SECTION("during an audition") {
        REQUIRE(otherShelf.auditionPreset("Bell.json"));
        saveTheirs();
        checkRefused();
        REQUIRE(otherShelf.auditionPreset("Bell.json"));
        checkSaved(7);
    }
    SECTION("after an audition that is starred and kept") {
        REQUIRE(otherShelf.auditionPreset("Bell.json"));
        saveTheirs();
        REQUIRE(otherShelf.setFavourite("Bell.json", true));
        otherShelf.keepAudition();
        two.view().parameters.change(tau, 7);
        checkRefused();
    }
    SECTION("during an audition of the newer file") {
        REQUIRE(otherShelf.loadPreset("Bell.json"));
        saveTheirs();
        otherShelf.readPresets();
        REQUIRE(otherShelf.auditionPreset("Bell.json"));
        CHECK(two.view().parameters.value(tau) == 3.0625);
        checkSaved(7);
    }
}

TEST_CASE("A project opened again saves over its preset, unless the file has changed meanwhile") {
    const UserSettings user;
    std::string project;
    {
        Processor processor; // a changed factory preset, which becomes a preset of its own
        processor.view().parameters.change(ParameterId::tau, 5);
        REQUIRE(processor.view().presets.savePreset(called("Mine"), false));
        project = saved(processor);
    }
    Processor processor;
    restoreBytes(processor, project);
    auto& shelf = processor.view().presets;
    shelf.readPresets();
    CHECK(shelf.playingPreset().id == "Mine.json");
    CHECK_FALSE(shelf.playingPreset().isChanged);
    processor.view().parameters.change(ParameterId::tau, 7);
    CHECK(shelf.playingPreset().isChanged);
    REQUIRE(shelf.saveChosenPreset());
    Processor late;
    restoreBytes(late, project); // older than the file now
    late.view().presets.readPresets();
    CHECK(late.view().presets.playingPreset().id == "Mine.json");
    CHECK_FALSE(late.view().presets.saveChosenPreset());
}

TEST_CASE("A preset that was read but did not play is not overwritten") {
    const UserSettings user;
    using enum ParameterId;
    Processor one, two;
    ReluctantHolder holder(two);
    HostLoads noLoads;
    SoundHistory history(holder, two.parameters(), noLoads);
    PresetCollection shelf(holder, history, two.view().workshop,
                           juce::File(user.folder().string()));
    REQUIRE(one.view().presets.savePreset(called("Bell"), false));
    REQUIRE(shelf.loadPreset("Bell.json"));
    two.view().parameters.change(tau, 5);
    one.view().parameters.change(tau, 3.0625);
    REQUIRE(one.view().presets.saveChosenPreset());
    const auto theirs = user.read("Presets/Bell.json");
    shelf.readPresets();
    holder.plays = false;
    REQUIRE(shelf.loadPreset("Bell.json"));
    CHECK(two.view().parameters.value(tau) == 5);
    CHECK_FALSE(shelf.saveChosenPreset());
    CHECK(user.read("Presets/Bell.json") == theirs);
}

TEST_CASE("After a save or rename, the sounds of A/B and undo belong to the saved preset") {
    const UserSettings user;
    using enum ParameterId;
    Processor processor;
    auto& shelf = processor.view().presets;
    REQUIRE(shelf.savePreset(called("Bell"), false));
    REQUIRE(shelf.loadPreset(factoryPresetId("Wok")));
    REQUIRE(shelf.loadPreset("Bell.json"));
    processor.view().variants.copyToOther();
    processor.view().parameters.change(tau, 5);
    REQUIRE(shelf.saveChosenPreset());
    const std::string name = GENERATE("Bell", "Gong");
    if (name != "Bell")
        REQUIRE(shelf.renamePreset("Bell.json", name));
    SECTION("compared sounds") {
        processor.view().variants.compare();
    }
    SECTION("sounds restored by undo") {
        for (int step = 0; step < 3; ++step)
            processor.windowSession().history.undo();
        CHECK(processor.windowSession().history.redoName() == "Wok");
    }
    CHECK(processor.view().parameters.value(tau) != 5);
    CHECK(shelf.playingPreset().details.name == name);
    CHECK(shelf.playingPreset().id == name + ".json");
    CHECK(shelf.playingPreset().isChanged); // compared with the file's new content
    processor.view().parameters.change(tau, 5);
    CHECK_FALSE(shelf.playingPreset().isChanged);
    processor.view().parameters.change(tau, 7);
    REQUIRE(shelf.saveChosenPreset());
    Processor other;
    REQUIRE(other.view().presets.loadPreset(name + ".json"));
    CHECK(other.view().parameters.value(tau) == 7);
}
