#include "Editor/PresetBar.h"

#include "Editor/EditorWindow.h"
#include "Editor/Look.h"
#include "Editor/WindowParts.h"
#include "Instrument/FactoryContent.h"
#include "Plugin/Processor.h"
#include "Support/UserSettings.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

struct Bar {
    UserSettings user;
    Processor processor;
    PresetBar bar{processor.view()};

    juce::Button& button(const char* title) {
        bar.refresh();
        return part<juce::Button>(bar, title);
    }
    void click(const char* title) {
        button(title).onClick();
        bar.refresh();
    }
    std::string shownName() { return button("Preset").getButtonText().toStdString(); }
};

juce::KeyPress command(int letter, int more = 0) {
    return {letter, juce::ModifierKeys(juce::ModifierKeys::commandModifier | more), 0};
}

void changeDensity(Processor& processor, double value) {
    processor.view().parameters.beginChange(ParameterId::density);
    processor.view().parameters.change(ParameterId::density, value);
    processor.view().parameters.endChange(ParameterId::density);
}

} // namespace

TEST_CASE("Previous and next load neighbouring presets, wrap at the ends and skip broken files") {
    Bar bar;
    bar.user.write("Presets/broken.json", "{");
    bar.processor.view().presets.readPresets();
    const int last = bar.processor.getNumPrograms() - 1;
    bar.click("Previous preset");
    CHECK(bar.processor.getCurrentProgram() == last);
    bar.click("Next preset");
    CHECK(bar.processor.getCurrentProgram() == 0);
    CHECK(bar.shownName() == factoryPresets()[0].name);
    bar.click("Next preset");
    CHECK(bar.shownName() == factoryPresets()[1].name);
    CHECK_FALSE(bar.processor.view().status.takeStatus().isError);
}

TEST_CASE("Undo and redo name their step, and work by click and by key") {
    Bar bar;
    CHECK_FALSE(bar.button("Undo").isEnabled());
    CHECK_FALSE(bar.button("Redo").isEnabled());
    const double before = bar.processor.view().parameters.value(ParameterId::density);
    const auto now = [&] { return bar.processor.view().parameters.value(ParameterId::density); };
    changeDensity(bar.processor, 1000);
    CHECK(bar.button("Undo").getTooltip().contains("Density"));
    bar.click("Undo");
    CHECK(now() == before);
    bar.click("Redo");
    CHECK(now() == 1000);
    CHECK(bar.bar.handleKey(command('z')));
    CHECK(now() == before);
    CHECK(bar.bar.handleKey(command('Z', juce::ModifierKeys::shiftModifier)));
    CHECK(now() == 1000);
    CHECK(bar.bar.handleKey(command('Z')));
    CHECK(bar.bar.handleKey(command('y')));
    CHECK(now() == 1000);
    CHECK_FALSE(bar.bar.handleKey(juce::KeyPress('z')));
    CHECK_FALSE(bar.bar.handleKey(command('q')));
}

TEST_CASE("Compare, copy and mutate change the sound, and undo reverts them") {
    Bar bar;
    auto& compare = bar.button("Compare A and B");
    CHECK_FALSE(compare.getToggleState());
    bar.click("Compare A and B");
    CHECK(compare.getToggleState());
    CHECK(find<juce::Button>(bar.bar, "Copy B to A") != nullptr);
    changeDensity(bar.processor, 1000);
    bar.click("Copy B to A");
    bar.click("Compare A and B");
    CHECK(bar.processor.view().parameters.value(ParameterId::density) == 1000);
    CHECK_FALSE(compare.getToggleState());
    const auto before = bar.processor.soundSession().loadedSound().parameters;
    bar.click("Mutate");
    CHECK_FALSE(bar.processor.soundSession().loadedSound().parameters == before);
    bar.click("Undo");
    CHECK(bar.processor.soundSession().loadedSound().parameters == before);
}

TEST_CASE("A click toggles a favourite; a sound without a preset cannot be one") {
    Bar bar;
    CHECK(bar.button("Favourite").isEnabled());
    bar.click("Favourite");
    CHECK(bar.button("Remove favourite").getToggleState());
    CHECK(bar.processor.view().presets.presets().front().isFavourite);
    bar.click("Remove favourite");
    CHECK_FALSE(bar.button("Favourite").getToggleState());
    REQUIRE(bar.processor.view().presets.loadInitialSound());
    CHECK_FALSE(bar.button("Favourite").isEnabled());
}

TEST_CASE("Saving asks for a name unless the preset is the user's own") {
    Bar bar;
    int asked = 0;
    bar.bar.onSaveAs = [&] { ++asked; };
    CHECK(bar.bar.handleKey(command('s')));
    CHECK(asked == 1);
    REQUIRE(bar.processor.view().presets.savePreset(
        {.name = "Mine", .folder = "", .author = "", .description = "", .tags = {}}, false));
    changeDensity(bar.processor, 1234);
    CHECK(bar.button("Preset").getDescription().startsWith("Changed"));
    bar.click("Save");
    CHECK(asked == 1);
    CHECK_FALSE(bar.button("Preset").getDescription().startsWith("Changed"));
    CHECK(bar.user.read("Presets/Mine.json").find("1234") != std::string::npos);
}

TEST_CASE("Saving overwrites the loaded file, even if another preset has the same name") {
    Bar bar;
    bar.bar.onSaveAs = [] { FAIL("it has a file"); };
    auto& shelf = bar.processor.view().presets;
    REQUIRE(shelf.savePreset(
        {.name = "Bell", .folder = "", .author = "", .description = "", .tags = {}}, false));
    const auto original = bar.user.read("Presets/Bell.json");
    bar.user.write("Presets/Bell (copy).json", original); // as a file manager copies it
    bar.user.write("Presets/Other/from a friend.json", original);
    shelf.readPresets();
    for (const auto* copy : {"Bell (copy).json", "Other/from a friend.json"}) {
        REQUIRE(shelf.loadPreset(copy));
        changeDensity(bar.processor, 1234);
        bar.click("Save");
        CHECK_FALSE(bar.processor.view().status.takeStatus().isError);
        CHECK(shelf.playingPreset().id == copy);
        CHECK_FALSE(shelf.playingPreset().isChanged);
        CHECK(bar.user.read("Presets/Bell.json") == original);
        CHECK(bar.user.read(std::string("Presets/") + copy).find("1234") != std::string::npos);
        CHECK_FALSE(std::filesystem::exists(bar.user.folder() / "Presets/Other/Bell.json"));
    }
}

TEST_CASE("The status shows a failed save in one sentence") {
    Bar bar;
    REQUIRE(bar.processor.view().presets.savePreset(
        {.name = "Mine", .folder = "In", .author = "", .description = "", .tags = {}}, false));
    std::filesystem::remove_all(bar.user.folder() / "Presets");
    std::ofstream(bar.user.folder() / "Presets") << "in the way";
    bar.click("Save");
    const auto status = bar.processor.view().status.takeStatus();
    CHECK(status.isError);
    CHECK(status.sentence.back() == '.');
}

TEST_CASE("The bar's parts fit and do not overlap at any width from 640 pixels") {
    Bar bar;
    for (const int width : {640, 734, 1180, 3840}) {
        bar.bar.setSize(width, 44);
        const auto& children = bar.bar.getChildren();
        for (const auto* child : children) {
            INFO(width << " " << child->getTitle());
            CHECK(bar.bar.getLocalBounds().contains(child->getBounds()));
            CHECK(child->getWidth() >= 24);
            CHECK(child->getHeight() >= 24);
            for (const auto* other : children)
                CHECK((other == child || !other->getBounds().intersects(child->getBounds())));
        }
        CHECK(find<juce::Button>(bar.bar, "Preset")->getWidth() >= 150);
    }
}

TEST_CASE("Every button of the bar has a unique name and a tooltip") {
    Bar bar;
    juce::StringArray names;
    for (auto* child : bar.bar.getChildren()) {
        CHECK(child->getTitle().isNotEmpty());
        CHECK_FALSE(names.contains(child->getTitle()));
        names.add(child->getTitle());
        CHECK(dynamic_cast<juce::Button*>(child)->getTooltip().isNotEmpty());
    }
    CHECK(names.size() == 10);
}

TEST_CASE("The bar's shortcuts work anywhere in the window") {
    const UserSettings user;
    Processor processor;
    const std::unique_ptr<juce::AudioProcessorEditor> window(processor.createEditor());
    changeDensity(processor, 1000);
    CHECK(window->keyPressed(command('z')));
    CHECK(processor.windowSession().history.canRedo());
    CHECK_FALSE(window->keyPressed(juce::KeyPress('z')));
}
