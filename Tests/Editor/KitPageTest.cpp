// Tests of the page that edits a kit, and of the texts on it.
#include "Editor/KitPage.h"

#include "Editor/KeyboardPanel.h"
#include "Editor/OpenWindow.h"
#include "Editor/WindowParts.h"
#include "Plugin/FactoryPrograms.h"
#include "Support/ImportedFiles.h"
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

/// The page with the Junkyard Kit or, without one, with the test keyboard.
struct Rig {
    explicit Rig(bool isKit = true) {
        restore(processor, testState());
        if (isKit)
            REQUIRE(processor.view().presets.loadPreset(factoryPresetId("Junkyard Kit")));
        page.onKeysShown = [this](const auto& keys) { marked = keys; };
        page.setSize(DeckPage::minimumWidth, DeckPage::minimumHeight);
        page.setVisible(true);
        page.refresh();
    }

    template <class Kind>
    Kind& part(const juce::String& title) {
        return test::part<Kind>(page, title);
    }
    void type(const juce::String& field, const juce::String& text) {
        part<juce::Label>(field).setText(text, juce::sendNotificationSync);
    }
    juce::String text(const juce::String& field) { return part<juce::Label>(field).getText(); }
    KitView::Part kitPart(std::size_t index) { return processor.view().kit.kitParts().at(index); }

    Processor processor;
    KitPage page{processor.view()};
    std::optional<InstrumentView::KeyRange> marked;
};

} // namespace

TEST_CASE("Names and numbers of keys are parsed, in capitals or not") {
    for (int note = 0; note < 128; ++note) {
        CHECK(parseNoteName(noteName(note)) == note);
        CHECK(parseNoteName(" " + juce::String(note)) == note);
    }
    CHECK(parseNoteName("f#3") == 54);
    CHECK(parseNoteName("Gb3") == 54);
    for (const auto* wrong : {"", "H3", "C", "128", "-1", "C#10", "key"})
        CHECK_FALSE(parseNoteName(wrong));
    CHECK(keysText({.lowest = 36, .highest = 36}) == "C2");
    CHECK(keysText({.lowest = 36, .highest = 59}) == fromUtf8("C2\xe2\x80\x93"
                                                              "B3"));
}

TEST_CASE("A part is described in words with its own material and mallet") {
    const KitView::Part part{.object = "Cowbell",
                             .lowestNote = 56,
                             .highestNote = 56,
                             .levelDb = -5.4,
                             .chokeGroup = 2,
                             .material = ownMaterial};
    CHECK(partText(part) == fromUtf8("Cowbell, keys G#3, velocities 1\xe2\x80\x93"
                                     "127, -5.4 dB, "
                                     "choke group 2, Own"));
}

TEST_CASE("The page lists the parts of a kit, and its fields show the selected one") {
    Rig rig;
    auto& list = rig.part<juce::ListBox>("Parts");
    CHECK(list.getListBoxModel()->getNumRows() == 24);
    CHECK(rig.text("Lowest key of the part") == "C2");
    CHECK(rig.part<juce::ComboBox>("Material of the part").getText() == "Padauk");
    CHECK(rig.part<juce::ComboBox>("Choke group of the part").getText() == "None");
    list.selectRow(2);
    CHECK(rig.text("Lowest key of the part") == "D2");
    CHECK(rig.text("Level of the part") == "-4.5 dB");
    CHECK(rig.part<juce::ComboBox>("Material of the part").getText() == "As the sound");
    CHECK(rig.part<juce::ComboBox>("Mallet of the part").getText() == "Hard plastic");
    CHECK(rig.marked == InstrumentView::KeyRange{.lowest = 38, .highest = 38});
    rig.page.setVisible(false);
    CHECK_FALSE(rig.marked);
}

TEST_CASE("Typed figures and chosen items change the part; a text that is no figure does not") {
    Rig rig;
    rig.type("Highest velocity of the part", "100");
    rig.type("Level of the part", "-12,5");
    rig.part<juce::ComboBox>("Choke group of the part")
        .setSelectedId(4, juce::sendNotificationSync);
    rig.part<juce::ComboBox>("Output of the part").setSelectedId(3, juce::sendNotificationSync);
    rig.part<juce::ComboBox>("Material of the part").setSelectedId(1, juce::sendNotificationSync);
    CHECK(rig.kitPart(0).highestVelocity == 100);
    CHECK(rig.kitPart(0).levelDb == -12.5);
    CHECK(rig.kitPart(0).chokeGroup == 3);
    CHECK(rig.kitPart(0).output == 2);
    CHECK_FALSE(rig.kitPart(0).material);
    const auto before = rig.kitPart(0);
    for (const auto* field :
         {"Lowest key of the part", "Highest velocity of the part", "Level of the part"}) {
        const auto text = rig.text(field);
        rig.type(field, "loud");
        CHECK(rig.text(field) == text);
    }
    CHECK(rig.kitPart(0) == before);
    CHECK(rig.processor.windowSession().history.undoName() == "Material of Wood block");
}

TEST_CASE("A key typed beyond the other end moves both; a refused one is shown no more") {
    Rig rig;
    rig.type("Lowest key of the part", "C4");
    CHECK(rig.text("Highest key of the part") == "C4");
    CHECK(rig.kitPart(0).lowestNote == 60);
    rig.type("Highest key of the part", "36");
    CHECK(rig.text("Lowest key of the part") == "C2");
    rig.type("Lowest velocity of the part", "90");
    rig.type("Highest velocity of the part", "20");
    CHECK(rig.kitPart(0).lowestVelocity == 20);
    rig.type("Highest velocity of the part", "127");
    rig.part<juce::ListBox>("Parts").selectRow(1);
    rig.type("Lowest key of the part", "C2"); // beside the first part, up to C#2
    rig.part<juce::ListBox>("Parts").selectRow(2);
    rig.type("Lowest key of the part", "C2");
    CHECK(rig.text("Lowest key of the part") == "D2");
    CHECK(rig.processor.view().status.takeStatus().sentence.starts_with("Brake drum stays"));
}

TEST_CASE("The buttons remove a part and say on which key the next object goes") {
    Rig rig;
    auto& add = rig.part<juce::TextButton>("Add an object to the kit");
    CHECK(add.getButtonText() == "Add object on C4..."); // above the kit, C2 to B3
    rig.part<juce::ListBox>("Parts").selectRow(4);
    rig.part<juce::TextButton>("Remove the part").onClick();
    CHECK(rig.processor.view().kit.kitParts().size() == 23);
    CHECK(add.getButtonText() == "Add object on E2..."); // now free
    rig.page.chooseKey(38);
    CHECK(rig.text("Lowest key of the part") == "D2"); // the part that plays it
    CHECK(add.getButtonText() == "Add object on D2...");
    rig.page.chooseKey(70);
    rig.page.addObject(smallPlateFile("plate.obj", 1));
    CHECK(add.getButtonText() == "Add object on E2...");
    rig.page.addObject(smallPlateFile("other.obj", 1));
    CHECK(add.getButtonText() == "Add object on C4..."); // the first two keys wait for objects
    auto& bar = rig.part<WorkBar>({});
    CHECK(bar.isVisible());
    rig.processor.view().workshop.cancelImport();
    rig.page.refresh();
    CHECK_FALSE(bar.isVisible());
    CHECK(add.getButtonText() == "Add object on E2...");
}

TEST_CASE("Another sound shows how to make a kit, and a button makes one") {
    Rig rig(false);
    auto& make = rig.part<juce::TextButton>("Make a kit of this sound");
    auto& list = rig.part<juce::ListBox>("Parts");
    CHECK(rig.part<juce::TextEditor>("How to make a kit").getText().contains("drop a mesh"));
    CHECK_FALSE(list.isVisible());
    make.onClick();
    CHECK(list.isVisible());
    CHECK_FALSE(make.isVisible());
    CHECK_FALSE(rig.part<juce::TextButton>("Remove the part").isEnabled());
    CHECK(rig.marked == InstrumentView::KeyRange{.lowest = 60, .highest = 72});
    rig.page.chooseKey(64);
    REQUIRE(rig.processor.view().presets.loadPreset(factoryPresetId("Falling Rings")));
    rig.page.refresh();
    CHECK_FALSE(make.isEnabled());
    CHECK(rig.part<juce::TextEditor>("How to make a kit").getText() ==
          "This sound cannot be a kit: the keys play a scene.");
    REQUIRE(rig.processor.view().presets.loadPreset(factoryPresetId("Junkyard Kit")));
    rig.page.refresh();
    CHECK(rig.page.keyToAdd() == 60); // not the key that was chosen for another sound
    CHECK(rig.text("Lowest key of the part") == "C2");
}

TEST_CASE("A key that is played in the window selects its part on the Kit page") {
    Processor processor;
    REQUIRE(processor.view().presets.loadPreset(factoryPresetId("Junkyard Kit")));
    const auto window = open(processor);
    auto* keyboard = find<juce::MidiKeyboardComponent>(*window, "Keyboard");
    auto* panel = dynamic_cast<KeyboardPanel*>(keyboard->getParentComponent());
    REQUIRE(panel != nullptr);
    panel->onKey(40);
    CHECK(find<juce::Label>(*window, "Lowest key of the part")->getText() == "E2");
}

TEST_CASE("A file dropped on a key shows the Kit page, and elsewhere the Object page") {
    Processor processor;
    const auto window = open(processor);
    window->setSize(1180, 860);
    auto* target = dynamic_cast<juce::FileDragAndDropTarget*>(window.get());
    const auto* kit = find<juce::TextEditor>(*window, "How to make a kit");
    const auto* object = find<juce::TextEditor>(*window, "What was made of the file");
    const juce::String file(writtenFile("nothing.obj", "").string());
    target->filesDropped({file}, 30, window->getHeight() - 30);
    CHECK(isOnScreen(*kit, *window));
    target->filesDropped({file}, 30, 300);
    CHECK(isOnScreen(*object, *window));
}
