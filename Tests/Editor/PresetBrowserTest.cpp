#include "Editor/PresetBrowser.h"

#include "Editor/EditorWindow.h"
#include "Editor/PresetPictures.h"
#include "Editor/WindowParts.h"
#include "Instrument/FactoryContent.h"
#include "Support/HomeFolder.h"
#include "Support/TestSound.h"
#include "Support/UserSettings.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

PresetDetails called(const std::string& name, const std::string& folder = "") {
    return {.name = name, .folder = folder, .author = "", .description = "", .tags = {"mine"}};
}

struct Browser {
    UserSettings user;
    Processor processor;
    PresetCollection& shelf = processor.windowSession().presets;
    PresetBrowser browser{shelf};
    int closed = 0;

    Browser() {
        browser.onClose = [this] { ++closed; };
        browser.setSize(776, 360);
        browser.open();
    }

    template <class Kind>
    Kind& part(const char* title) {
        return test::part<Kind>(browser, title);
    }
    PresetList& list() { return part<PresetList>("Presets"); }
    int rows() { return list().getListBoxModel()->getNumRows(); }
    void type(const char* words) {
        part<juce::TextEditor>("Search presets").setText(juce::String::fromUTF8(words));
        part<juce::TextEditor>("Search presets").onTextChange();
    }
    void click(const char* title) { part<juce::TextButton>(title).onClick(); }
    void press(int key) { browser.keyPressed(juce::KeyPress(key)); }
    /// Types into a field of the form.
    void fill(const char* title, const juce::String& text) {
        auto& editor = part<juce::TextEditor>(title);
        editor.setText(text, false);
        editor.onTextChange();
    }
};

const int factoryCount = static_cast<int>(factoryPresets().size());

} // namespace

TEST_CASE("The browser shows all presets and selects the current one") {
    Browser b;
    CHECK(b.rows() == factoryCount);
    REQUIRE(b.list().selected() != nullptr);
    CHECK(b.list().selected()->name == factoryPresets()[0].name);
    CHECK(b.processor.view().status.takeStatus().isError == false);
}

TEST_CASE("Each factory preset has a small picture, and a preset of the user's a plain glyph") {
    const auto drawn = [](const ShelvedPreset& preset) {
        juce::Image image(juce::Image::ARGB, 96, 64, true);
        juce::Graphics g(image);
        PresetPictures().draw(g, image.getBounds().toFloat(), preset, juce::Colours::red);
        return image;
    };
    const auto isPlain = [](const juce::Image& image) {
        for (int x = 0; x < image.getWidth(); ++x)
            if (const auto pixel = image.getPixelAt(x, 32);
                pixel.getAlpha() > 0 && pixel.getGreen() > 0)
                return false;
        return true;
    };
    Browser b;
    for (auto preset : b.shelf.presets()) {
        INFO(preset.name);
        const auto file = presetPictureFile(preset.name);
        CHECK(file.size() <= 12000);
        const auto picture = juce::ImageFileFormat::loadFrom(file.data(), file.size());
        CHECK(picture.getWidth() == PresetPictures::width);
        CHECK(picture.getHeight() == PresetPictures::height);
        CHECK_FALSE(isPlain(drawn(preset)));
        preset.isFactory = false;
        CHECK(isPlain(drawn(preset)));
        CHECK(drawn(preset).getPixelAt(48, 32).getAlpha() > 0);
    }
    CHECK(presetPictureFile("no such preset").empty());
}

TEST_CASE("Search words narrow the list; an empty search shows all") {
    Browser b;
    b.type("XYLOphone rosewood");
    CHECK(b.rows() >= 1);
    CHECK(b.rows() < factoryCount);
    b.type("no such sound");
    CHECK(b.rows() == 0);
    b.type("");
    CHECK(b.rows() == factoryCount);
}

TEST_CASE("A search with typing errors lists similar presets and says so; exact ones come first") {
    Browser b;
    const auto first = [&] { return b.list().getListBoxModel()->getNameForRow(0).toStdString(); };
    for (const auto& [typed, found] : {std::pair("vibrafone", "Vibraphone"),
                                       {"marinba", "Marimba"},
                                       {"xylofon", "Rosewood Xylophone"},
                                       {"glockenspeil", "Glockenspiel"}}) {
        b.type(typed);
        CHECK(first().starts_with(found));
        CHECK(b.part<juce::Label>("Message").getText().contains("similar"));
    }
    REQUIRE(b.shelf.savePreset(called("Zlass"), false));
    b.browser.open();
    b.type("glass");
    CHECK(first().starts_with("Glass Ring"));
    b.type("zlass");
    CHECK(first().starts_with("Zlass"));
    CHECK(b.part<juce::Label>("Message").getText() == "");
    b.click("Init");
    b.type("glass"); // only a message about the search ends with it
    CHECK(b.part<juce::Label>("Message").getText() == "A plain sound plays.");
}

TEST_CASE("One button clears the search and all filters; it is there while any narrows the list") {
    Browser b;
    auto& clear = b.part<juce::TextButton>("Clear");
    CHECK_FALSE(clear.isVisible());
    b.type("wok");
    CHECK(clear.isVisible());
    b.part<juce::ListBox>("Tags").selectRow(0, false, false);
    b.type("");
    CHECK(clear.isVisible());
    b.part<juce::ListBox>("From").selectRow(1);
    CHECK(b.rows() == 0);
    b.click("Clear");
    CHECK(b.rows() == factoryCount);
    CHECK(b.part<juce::TextEditor>("Search presets").isEmpty());
    CHECK(b.part<juce::ListBox>("Tags").getNumSelectedRows() == 0);
    CHECK(b.part<juce::ListBox>("From").getSelectedRow() == 0);
    CHECK_FALSE(clear.isVisible());
}

TEST_CASE("Arrows play presets, Return keeps one as one step, and Escape restores the old sound") {
    Browser b;
    const auto before = saved(b.processor);
    b.press(juce::KeyPress::downKey);
    b.press(juce::KeyPress::downKey);
    CHECK(b.processor.getCurrentProgram() == 2);
    SECTION("Return") {
        b.press(juce::KeyPress::returnKey);
        CHECK(b.closed == 1);
        CHECK(b.processor.getCurrentProgram() == 2);
        b.processor.windowSession().history.undo();
        CHECK(saved(b.processor) == before);
        CHECK_FALSE(b.processor.windowSession().history.canUndo());
    }
    SECTION("Escape") {
        b.press(juce::KeyPress::escapeKey);
        CHECK(b.closed == 1);
        CHECK(saved(b.processor) == before);
        CHECK_FALSE(b.processor.windowSession().history.canUndo());
    }
    SECTION("up to the first preset and further") {
        for (int i = 0; i < 5; ++i)
            b.press(juce::KeyPress::upKey);
        CHECK(b.processor.getCurrentProgram() == 0);
    }
    SECTION("a search does not change the sound") {
        b.type("wok");
        CHECK(b.processor.getCurrentProgram() == 2);
    }
}

TEST_CASE("In the search field arrows move through the list, and other keys are typed") {
    Browser b;
    auto& search = b.part<juce::TextEditor>("Search presets");
    using juce::KeyPress;
    for (const int key : {KeyPress::downKey, KeyPress::upKey, KeyPress::pageDownKey})
        CHECK_FALSE(search.keyPressed(KeyPress(key)));
    CHECK(search.keyPressed(KeyPress('w', 0, 'w')));
    CHECK(search.getText() == "w");
}

TEST_CASE("Sources and tags narrow the list together") {
    Browser b;
    REQUIRE(b.shelf.savePreset(called("Mine", "Bells/Small"), false));
    REQUIRE(b.shelf.savePreset(called("Yours", "Bells"), false));
    REQUIRE(b.shelf.setFavourite("Bells/Yours.json", true));
    b.browser.open();
    auto& sources = b.part<juce::ListBox>("From");
    auto& tags = b.part<juce::ListBox>("Tags");
    const auto choose = [&](juce::ListBox& box, const juce::String& name) {
        auto* model = box.getListBoxModel();
        for (int row = 0; row < model->getNumRows(); ++row)
            if (model->getNameForRow(row).trim() == name)
                return box.selectRow(row, false, &box != &tags);
        FAIL("no " << name);
    };
    CHECK(b.rows() == factoryCount + 2);
    choose(sources, "Factory");
    CHECK(b.rows() == factoryCount);
    choose(sources, "Yours");
    CHECK(b.rows() == 2);
    choose(sources, "Bells");
    CHECK(b.rows() == 2);
    choose(sources, "Bells/Small");
    CHECK(b.rows() == 1);
    choose(sources, "Favourites");
    CHECK(b.rows() == 1);
    choose(sources, "All");
    choose(tags, "mine");
    CHECK(b.rows() == 2);
    choose(tags, "metal");
    CHECK(b.rows() == 0); // both tags
    CHECK(b.part<juce::Label>("Message").getText().startsWith("No preset"));
}

TEST_CASE("Saving under a new name adds a preset; overwriting another one asks first") {
    Browser b;
    b.click("Save as...");
    b.fill("Name", "Mine");
    b.fill("Folder", "Bells");
    b.fill("Tags", "bright, , short ;x");
    b.click("Save");
    REQUIRE(b.shelf.playingPreset().id == "Bells/Mine.json");
    CHECK(b.shelf.presets().back().tags == std::vector<std::string>{"bright", "short", "x"});
    CHECK(b.list().selected()->name == "Mine");

    b.processor.view().parameters.change(ParameterId::tau, 7);
    b.click("Save as...");
    b.click("Save");
    CHECK(b.shelf.playingPreset().isChanged);
    b.fill("Name", "Other");
    b.fill("Name", "Mine"); // typing makes Save ask again
    b.click("Save");
    CHECK(b.shelf.playingPreset().isChanged);
    b.click("Replace");
    CHECK_FALSE(b.shelf.playingPreset().isChanged);
}

TEST_CASE("The save shortcut does not overwrite the old preset while the form is open") {
    Browser b;
    REQUIRE(b.shelf.savePreset(called("Mine"), false));
    b.processor.view().parameters.change(ParameterId::tau, 7);
    b.click("Save as...");
    b.fill("Name", "Other");
    const juce::KeyPress save('s', juce::ModifierKeys::commandModifier, 19);
    CHECK(b.browser.keyPressed(save));
    CHECK(b.shelf.playingPreset().isChanged);
    b.click("Cancel");
    CHECK_FALSE(b.browser.keyPressed(save)); // the key is left to the window
}

TEST_CASE("The form refuses an invalid file name and stays open") {
    Browser b;
    b.click("Save as...");
    b.fill("Name", "///");
    b.click("Save");
    CHECK(isOnScreen(b.part<juce::TextEditor>("Name"), b.browser));
    CHECK(b.rows() == factoryCount);
    b.browser.keyPressed(juce::KeyPress(juce::KeyPress::escapeKey));
}

TEST_CASE("Escape keeps an auditioned sound that was saved") {
    Browser b;
    b.press(juce::KeyPress::downKey);
    b.click("Save as...");
    b.fill("Name", "Second");
    b.click("Save");
    b.press(juce::KeyPress::escapeKey);
    CHECK(b.shelf.playingPreset().id == "Second.json");
}

TEST_CASE("Only the user's presets can be renamed and deleted") {
    Browser b;
    CHECK_FALSE(b.part<juce::TextButton>("Rename").isEnabled());
    CHECK_FALSE(b.part<juce::TextButton>("Delete").isEnabled());
    REQUIRE(b.shelf.savePreset(called("Mine"), false));
    b.browser.open();
    CHECK(b.part<juce::TextButton>("Delete").isEnabled());
    b.click("Rename");
    b.fill("Name", "Ours");
    auto* yes = find<juce::TextButton>(b.browser, "Rename preset");
    REQUIRE(yes != nullptr);
    yes->onClick();
    CHECK(b.shelf.playingPreset().id == "Ours.json");
    CHECK(b.list().selected()->name == "Ours");
#if JUCE_LINUX
    const HomeFolder home;
    b.click("Delete");
    b.click("Cancel");
    CHECK(b.rows() == factoryCount + 1);
    b.click("Delete");
    find<juce::TextButton>(b.browser, "Delete preset")->onClick();
    CHECK(b.rows() == factoryCount);
    CHECK(b.shelf.playingPreset().id.empty());
#endif
}

#if JUCE_LINUX
TEST_CASE("Confirming a deletion never deletes a preset selected later") {
    Browser b;
    b.user.write("Presets/broken.json", "{");
    REQUIRE(b.shelf.savePreset(called("Mine"), false));
    b.browser.open();
    const auto isAsked = [&] {
        const auto* yes = find<juce::TextButton>(b.browser, "Delete preset");
        return yes != nullptr && isOnScreen(*yes, b.browser);
    };
    b.click("Delete");
    CHECK(isAsked());
    b.press(juce::KeyPress::upKey);
    CHECK_FALSE(isAsked());

    b.press(juce::KeyPress::escapeKey);
    b.browser.open();
    b.type("broken");
    b.press(juce::KeyPress::downKey);
    b.click("Delete");
    b.type("");
    CHECK(b.list().selected()->name == "Mine");
    const HomeFolder home;
    find<juce::TextButton>(b.browser, "Delete preset")->onClick();
    CHECK(b.rows() == factoryCount + 1);
    CHECK(b.shelf.playingPreset().id == "Mine.json");
}
#endif

TEST_CASE("A broken preset is listed and does not change the sound") {
    Browser b;
    b.user.write("Presets/broken.json", "{");
    b.browser.open();
    const auto before = saved(b.processor);
    b.type("broken");
    REQUIRE(b.rows() == 1);
    b.press(juce::KeyPress::downKey);
    CHECK(saved(b.processor) == before);
    CHECK_FALSE(b.part<juce::TextButton>("Rename").isEnabled());
    CHECK(b.part<juce::TextButton>("Delete").isEnabled());
}

TEST_CASE("The browser's parts fit from its minimum size on and do not overlap, also while it asks "
          "for a name") {
    Browser b;
    for (const auto& [width, height] : {std::pair(640, 300), {776, 354}, {3800, 1900}}) {
        b.browser.setSize(width, height);
        b.type(width > 640 ? "o" : ""); // with a button that clears it, and without
        for (const bool asking : {false, true}) {
            b.browser.open();
            if (asking)
                b.click("Save as...");
            std::vector<juce::Rectangle<int>> places;
            for (auto* child : b.browser.getChildren()) {
                if (!child->isVisible())
                    continue;
                INFO(width << " " << child->getTitle());
                CHECK(b.browser.getLocalBounds().contains(child->getBounds()));
                for (const auto& other : places)
                    CHECK_FALSE(other.intersects(child->getBounds()));
                places.push_back(child->getBounds());
            }
            CHECK((asking || b.list().isVisible()));
            CHECK((!b.list().isVisible() || b.list().getHeight() >= 60));
        }
    }
}

TEST_CASE("Closing the window with the browser open keeps the sound as one step") {
    const UserSettings user;
    Processor processor;
    {
        const std::unique_ptr<juce::AudioProcessorEditor> window(processor.createEditor());
        find<juce::Button>(*window, "Preset")->onClick();
        auto* browser = find<PresetBrowser>(*window, "Preset browser");
        REQUIRE(browser != nullptr);
        CHECK(browser->isVisible());
        browser->keyPressed(juce::KeyPress(juce::KeyPress::downKey));
    }
    CHECK(processor.getCurrentProgram() == 1);
    processor.windowSession().history.undo();
    CHECK(processor.getCurrentProgram() == 0);
    CHECK_FALSE(processor.windowSession().history.canUndo());
}
