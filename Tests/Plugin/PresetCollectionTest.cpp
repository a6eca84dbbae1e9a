// Effects of the preset collection on the sound and on the user's files.
#include "Plugin/PresetCollection.h"

#include "Instrument/FactoryContent.h"
#include "Plugin/FactoryPrograms.h"
#include "Plugin/PresetsAtHand.h"
#include "Support/HomeFolder.h"
#include "Support/TestSound.h"
#include "Support/UserSettings.h"

#include <algorithm>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;

namespace {

/// Automation moves a parameter each time the sound is read.
class AutomatedHolder final : public ForwardingHolder {
public:
    AutomatedHolder(Processor& held, ParameterId moved)
        : ForwardingHolder(held), automated(*held.getParameters()[static_cast<int>(moved)]) {}

    Sound loadedSound() const override {
        auto sound = ForwardingHolder::loadedSound();
        automated.setValue(place += 0.1f);
        return sound;
    }

    bool isWhereItWasMoved() const { return std::abs(automated.getValue() - place) < 1e-6f; }

private:
    juce::AudioProcessorParameter& automated;
    mutable float place = 0;
};

HostSound firstSecond(Processor& processor) {
    processor.prepareToPlay(48000, 480);
    return render(processor, 48000, 480, testMusic(48000, 4801));
}

} // namespace

TEST_CASE("Factory presets are listed in the order of the programs") {
    const UserSettings user;
    Processor processor;
    auto& shelf = processor.view().presets;
    shelf.readPresets();
    REQUIRE(shelf.presets().size() == factoryPresets().size());
    for (std::size_t i = 0; i < factoryPresets().size(); ++i) {
        CHECK(shelf.presets()[i].name == factoryPresets()[i].name);
        CHECK(shelf.presets()[i].isFactory);
        REQUIRE(shelf.loadPreset(shelf.presets()[i].id));
        CHECK(processor.getCurrentProgram() == static_cast<int>(i));
        CHECK(shelf.playingPreset().id == shelf.presets()[i].id);
        CHECK_FALSE(shelf.playingPreset().isChanged);
    }
}

TEST_CASE("A saved preset loads unchanged and plays the same samples") {
    const UserSettings user;
    Processor processor;
    auto& shelf = processor.view().presets;
    processor.setCurrentProgram(3);
    processor.view().parameters.change(ParameterId::density, 1234.5);
    processor.view().parameters.change(ParameterId::size, 1.5);
    CHECK(shelf.playingPreset().isChanged);
    const auto values = processor.soundSession().loadedSound().parameters;
    REQUIRE(shelf.savePreset(called("Mine", "Tests"), false));
    CHECK_FALSE(shelf.playingPreset().isChanged);
    CHECK(shelf.playingPreset().id == "Tests/Mine.json");
    CHECK(processor.getCurrentProgram() == 0); // no longer a factory preset
    const auto expected = firstSecond(processor);

    Processor other;
    auto& otherShelf = other.view().presets;
    otherShelf.readPresets();
    const auto* mine = find(otherShelf, "Mine");
    REQUIRE(mine != nullptr);
    CHECK(mine->folder == "Tests");
    CHECK(mine->author == "Anna");
    CHECK(mine->tags == std::vector<std::string>{"test", "small"});
    CHECK_FALSE(mine->isFactory);
    REQUIRE(otherShelf.loadPreset(mine->id));
    CHECK(other.soundSession().loadedSound().parameters == values);
    CHECK(otherShelf.playingPreset().details.folder == "Tests");
    CHECK(firstSecond(other) == expected);
}

TEST_CASE("A preset saved while foreign objects play opens later and elsewhere") {
    const UserSettings user;
    HostSound expected;
    {
        Processor processor;
        restore(processor, testState("stones"));
        REQUIRE(processor.view().presets.savePreset(called("Stones", "Found"), false));
        expected = firstSecond(processor);
        REQUIRE(loudest(expected) > 0.001f);
    }
    Processor processor;
    auto& shelf = processor.view().presets;
    REQUIRE(shelf.loadPreset("Found/Stones.json"));
    CHECK(firstSecond(processor) == expected);

    // A project saved from the preset does not need the preset any more.
    const auto project = saved(processor);
    CHECK(project.find(user.folder().string()) == std::string::npos);
    std::filesystem::remove_all(user.folder() / "Presets");
    Processor reopened;
    restoreBytes(reopened, project);
    CHECK_FALSE(reopened.view().status.takeStatus().isError);
    CHECK(firstSecond(reopened) == expected);
}

TEST_CASE("A folder made by idiophone tune plays from inside the preset folder") {
    const UserSettings user;
    Preset preset;
    preset.name = "Tuned marimba";
    preset.keyMap.lowestNote = 60;
    preset.keyMap.highestNote = 61;
    preset.keyMap.object = "marimba-{note}.modal";
    user.write("Presets/My bars/marimba.json", encodePreset(preset));
    for (const auto* name : {"marimba-60", "marimba-61"}) {
        const auto bytes = factoryObject(name).value();
        user.write("Presets/My bars/" + std::string(name) + ".modal",
                   {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
    Processor processor;
    auto& shelf = processor.view().presets;
    shelf.readPresets();
    const auto* tuned = find(shelf, "Tuned marimba");
    REQUIRE(tuned != nullptr);
    REQUIRE(shelf.loadPreset(tuned->id));
    CHECK_FALSE(processor.view().status.takeStatus().isError);
    CHECK(shelf.playingPreset().id == "My bars/marimba.json");
    for (const int note : {59, 60, 61, 62})
        CHECK(processor.soundSession().instrument()->hasOwn(note) == (note == 60 || note == 61));
}

TEST_CASE("A preset saved with loudness matching is equally loud when it is loaded") {
    const UserSettings user;
    Processor processor;
    restore(processor, testState());
    using enum ParameterId;
    processor.view().parameters.change(matchLoudness, 1);
    processor.view().parameters.change(material, customMaterial);
    processor.view().parameters.change(density, 3000);
    processor.view().parameters.change(malletHardness, 3000);
    const auto expected = firstSecond(processor);
    REQUIRE(processor.view().presets.savePreset(called("Loud"), false));
    Processor other;
    REQUIRE(other.view().presets.loadPreset("Loud.json"));
    CHECK(other.view().parameters.value(level) != processor.view().parameters.value(level));
    CHECK(loudest(firstSecond(other)) == Approx(loudest(expected)).epsilon(0.001));
    // Saving leaves the current sound as it is.
    CHECK(firstSecond(processor) == expected);
}

TEST_CASE("A matched gain beyond the maximum level is kept when a preset is loaded") {
    const UserSettings user;
    using enum ParameterId;
    Processor processor;
    auto state = testState();
    for (auto* values : {&state.preset.parameters, &state.parameters})
        values->set(level, 20);
    restore(processor, state);
    processor.view().parameters.change(matchLoudness, 1);
    processor.view().parameters.change(malletHardness, 300);
    processor.view().parameters.change(density, 20000);
    processor.view().parameters.change(material, customMaterial);
    const auto expected = firstSecond(processor);
    REQUIRE(processor.view().presets.savePreset(called("Loud"), false));
    CHECK(user.read("Presets/Loud.json").find("matchedTo") != std::string::npos);
    Processor other;
    auto& shelf = other.view().presets;
    REQUIRE(shelf.loadPreset("Loud.json"));
    CHECK(other.view().parameters.value(level) == 20);
    CHECK_FALSE(shelf.playingPreset().isChanged);
    CHECK(firstSecond(other) == expected);
    // The gain survives another save. Once the level parameter suffices, it replaces the gain.
    REQUIRE(shelf.saveChosenPreset());
    Processor third;
    REQUIRE(third.view().presets.loadPreset("Loud.json"));
    CHECK(firstSecond(third) == expected);
    third.view().parameters.change(level, -20);
    REQUIRE(third.view().presets.saveChosenPreset());
    CHECK(user.read("Presets/Loud.json").find("matchedTo") == std::string::npos);
    Processor fourth;
    REQUIRE(fourth.view().presets.loadPreset("Loud.json"));
    CHECK(loudest(firstSecond(fourth)) == Approx(loudest(firstSecond(third))).epsilon(0.001));
}

TEST_CASE("Saving never cuts ringing sound") {
    const UserSettings user;
    Processor processor, untouched;
    for (auto* each : {&processor, &untouched}) {
        restore(*each, testState());
        each->prepareToPlay(48000, 480);
        render(*each, 4800, 480, testMusic(4800, 500));
    }
    REQUIRE(processor.view().presets.savePreset(called("Ringing"), false));
    CHECK(render(processor, 4800, 480, {}) == render(untouched, 4800, 480, {}));
}

TEST_CASE("Renaming a sound keeps automated values") {
    const UserSettings user;
    Processor processor;
    AutomatedHolder holder(processor, ParameterId::width);
    PresetCollection shelf(holder, processor.windowSession().history, processor.view().workshop,
                           juce::File(user.folder().string()));
    REQUIRE(shelf.savePreset(called("One"), false));
    CHECK(holder.isWhereItWasMoved());
    CHECK(shelf.playingPreset().isChanged);
    REQUIRE(shelf.renamePreset("One.json", "Two"));
    CHECK(holder.isWhereItWasMoved());
    CHECK(processor.soundSession().loadedSound().preset.name == "Two");
    CHECK(processor.soundSession().loadedSound().preset.author == "Anna");
    CHECK(shelf.playingPreset().id == "Two.json");
}

TEST_CASE("A scene preset names its scene by a path without machine-specific folders") {
    const UserSettings user;
    user.write("Scenes/dice.json", R"({"format": "idiophone-scene", "version": 1, "name": "Mine",
        "kinds": [{"name": "plate", "object": "plate", "fixed": true},
                  {"name": "die", "object": "die"}],
        "bodies": [{"kind": "plate"}, {"kind": "die", "at": [0, 0, 0.2]}]})");
    Preset preset;
    preset.name = "Dice";
    preset.keyMap = {.kind = KeyMapKind::scene, .object = "Scenes/dice.json"};
    user.write("Presets/dice.json", encodePreset(preset));
    Processor processor;
    auto& shelf = processor.view().presets;
    REQUIRE(shelf.loadPreset("dice.json"));
    processor.view().parameters.change(ParameterId::tau, 5);
    REQUIRE(shelf.saveChosenPreset());
    REQUIRE(shelf.savePreset(called("Other dice", "Thrown"), false));
    for (const auto* file : {"Presets/dice.json", "Presets/Thrown/Other dice.json"}) {
        const auto text = user.read(file);
        CHECK(parsePreset(text, file)->keyMap.object == "Scenes/dice.json");
        CHECK(text.find(user.folder().string()) == std::string::npos);
    }
    REQUIRE(shelf.loadPreset("Thrown/Other dice.json"));
    CHECK_FALSE(processor.view().status.takeStatus().isError);
    CHECK(processor.view().stage.hasStage());
}

TEST_CASE("A load is one step of the history") {
    const UserSettings user;
    Processor processor;
    auto& shelf = processor.view().presets;
    const auto before = saved(processor);
    REQUIRE(shelf.loadPreset(factoryPresetId("Wok")));
    CHECK(processor.windowSession().history.undoName() == "Wok");
    processor.windowSession().history.undo();
    CHECK(saved(processor) == before);
    REQUIRE(shelf.loadInitialSound());
    CHECK(shelf.playingPreset().details.name == "Init");
    CHECK(shelf.playingPreset().id.empty());
    CHECK_FALSE(shelf.playingPreset().isChanged);
    CHECK(loudest(firstSecond(processor)) > 0.01f);
    processor.windowSession().history.undo();
    CHECK(saved(processor) == before);
}

TEST_CASE("Broken presets stay listed with an error, and loading them changes nothing") {
    const UserSettings user;
    user.write("Presets/Old/broken.json", "{");
    user.write("Presets/lost.json", [] {
        auto preset = factoryPresets()[3];
        preset.name = "Lost";
        preset.keyMap.object = "Objects/lost-12.modal";
        return encodePreset(preset);
    }());
    Processor processor;
    auto& shelf = processor.view().presets;
    shelf.readPresets();
    const auto* broken = find(shelf, "broken");
    REQUIRE(broken != nullptr);
    CHECK_THAT(broken->fault, ContainsSubstring("broken.json"));
    CHECK(broken->folder == "Old");
    const auto before = saved(processor);
    for (const auto* id :
         {"Old/broken.json", "nowhere.json", "", "factory:", "../favourites.json"}) {
        const auto loaded = shelf.loadPreset(id);
        REQUIRE_FALSE(loaded);
        CHECK_FALSE(loaded.error().message.empty());
        CHECK_FALSE(shelf.auditionPreset(id));
    }
    shelf.endAudition();
    CHECK(saved(processor) == before);
    CHECK_FALSE(processor.windowSession().history.canUndo());

    REQUIRE(shelf.loadPreset("lost.json"));
    const auto status = processor.view().status.takeStatus();
    CHECK(status.isError);
    CHECK_THAT(status.sentence, ContainsSubstring("Lost: Objects/lost-12.modal is missing"));
    CHECK(processor.soundSession().loadedSound().preset.name == "Lost");
    CHECK(shelf.playingPreset().id.empty()); // saving it needs confirmation
}

TEST_CASE("Favourites stay with the machine and follow a renamed preset") {
    const UserSettings user;
    Processor processor;
    auto& shelf = processor.view().presets;
    REQUIRE(shelf.savePreset(called("One"), false));
    REQUIRE(shelf.setFavourite("One.json", true));
    REQUIRE(shelf.setFavourite(factoryPresetId("Wok"), true));
    REQUIRE(shelf.renamePreset("One.json", "Two"));
    CHECK(shelf.playingPreset().id == "Two.json");
    CHECK(shelf.playingPreset().details.name == "Two");
    Processor other;
    other.view().presets.readPresets();
    for (const auto& preset : other.view().presets.presets())
        CHECK(preset.isFavourite == (preset.name == "Two" || preset.name == "Wok"));
    CHECK_FALSE(shelf.renamePreset(factoryPresetId("Wok"), "Pan"));
    CHECK_FALSE(shelf.deletePreset(factoryPresetId("Wok")));
}

#if JUCE_LINUX
TEST_CASE("A deleted preset plays on, goes to the bin and is no longer a favourite") {
    const UserSettings user;
    const HomeFolder home; // and so the bin
    Processor processor;
    auto& shelf = processor.view().presets;
    REQUIRE(shelf.savePreset(called("One"), false));
    REQUIRE(shelf.setFavourite("One.json", true));
    const auto instrument = processor.soundSession().instrument();
    REQUIRE(shelf.deletePreset("One.json"));
    CHECK(find(shelf, "One") == nullptr);
    CHECK(processor.soundSession().instrument() == instrument);
    CHECK(shelf.playingPreset().id.empty());
    CHECK(user.read("favourites.json").find("One") == std::string::npos);
    CHECK(std::filesystem::exists(testFolder() / "home/.local/share/Trash/files/One.json"));
}
#endif

TEST_CASE("Without a settings folder the factory presets are listed and saving fails") {
    Processor processor;
    PresetCollection shelf(processor.soundSession(), processor.windowSession().history,
                           processor.view().workshop, juce::File());
    shelf.readPresets();
    CHECK(shelf.presets().size() == factoryPresets().size());
    REQUIRE(shelf.loadPreset(shelf.presets()[2].id));
    CHECK_FALSE(shelf.savePreset(called("x"), false));
    CHECK_FALSE(shelf.setFavourite(shelf.presets()[2].id, true));
    CHECK_FALSE(shelf.presetFolder());
}
