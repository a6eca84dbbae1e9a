// Tests of the form that makes a material from a recording.
#include "Editor/MaterialForm.h"

#include "Editor/MaterialPage.h"
#include "Editor/WindowParts.h"
#include "Support/ImportedFiles.h"
#include "Support/PresetNumber.h"
#include "Support/RecordedStrike.h"
#include "Support/UserSettings.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;
using FitStage = MaterialFitStatus::Stage;

namespace {

struct Page {
    Page() {
        page.setSize(DeckPage::minimumWidth, DeckPage::minimumHeight);
        page.setVisible(true);
    }

    template <class Kind>
    Kind& part(const juce::String& title) {
        return test::part<Kind>(page, title);
    }
    bool isShown(const juce::String& title) {
        return isOnScreen(part<juce::Component>(title), page);
    }
    void click(const juce::String& title) {
        auto& button = part<juce::Button>(title);
        REQUIRE(button.isEnabled());
        REQUIRE(isShown(title));
        button.onClick();
    }
    void openForm() { click("Material from a recording"); }
    MaterialForm& form() {
        for (auto* child : page.getChildren())
            if (auto* found = dynamic_cast<MaterialForm*>(child))
                return *found;
        throw std::runtime_error("there is no form");
    }
    void choose(const juce::String& object) {
        auto& list = part<juce::ComboBox>("What was struck");
        for (int i = 0; i < list.getNumItems(); ++i)
            if (list.getItemText(i) == object)
                return list.setSelectedItemIndex(i, juce::sendNotificationSync);
        FAIL("the list has no item " << object);
    }

    UserSettings user;
    Processor processor;
    Look look;
    MaterialPage page{processor.view()};
};

} // namespace

TEST_CASE("The form stands in the place of the page's parts until it is closed") {
    Page p;
    CHECK_FALSE(p.isShown("What was struck"));
    p.openForm();
    CHECK(p.isShown("What was struck"));
    CHECK_FALSE(p.isShown("Material pad"));
    p.click("Close the form");
    CHECK(p.isShown("Material pad"));
    p.openForm();
    CHECK(p.form().keyPressed(juce::KeyPress(juce::KeyPress::escapeKey)));
    CHECK_FALSE(p.isShown("What was struck"));
}

TEST_CASE("The form's parts lie inside the smallest page, apart, named and with whole texts") {
    Page p;
    p.processor.setCurrentProgram(presetNumber("Steel Plate"));
    p.openForm();
    auto& list = p.part<juce::ComboBox>("What was struck");
    for (int item = 0; item < list.getNumItems(); ++item) {
        list.setSelectedItemIndex(item, juce::sendNotificationSync);
        INFO(list.getText());
        std::vector<juce::Rectangle<int>> places;
        visit(p.form(), [&](juce::Component& part) {
            const bool isLeaf = dynamic_cast<juce::Label*>(&part) != nullptr ||
                                dynamic_cast<juce::Button*>(&part) != nullptr ||
                                dynamic_cast<juce::TextEditor*>(&part) != nullptr;
            if (!isLeaf || !isOnScreen(part, p.page) ||
                dynamic_cast<juce::ComboBox*>(part.getParentComponent()) != nullptr)
                return;
            places.push_back(p.page.getLocalArea(&part, part.getLocalBounds()));
            INFO(part.getTitle() << " " << places.back().toString());
            CHECK(p.form().getBounds().contains(places.back()));
            CHECK_FALSE(places.back().isEmpty());
            CHECK((!part.getWantsKeyboardFocus() || part.getTitle().isNotEmpty()));
            if (auto* label = dynamic_cast<juce::Label*>(&part))
                CHECK(juce::GlyphArrangement::getStringWidth(label->getFont(), label->getText()) *
                          label->getMinimumHorizontalScale() <=
                      float(label->getWidth() * std::max(1, label->getHeight() / 17)));
        });
        for (std::size_t i = 0; i < places.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                CHECK_FALSE(places[i].intersects(places[j]));
    }
}

TEST_CASE("The object that is shown is in the list while there is a single one") {
    Page p;
    p.openForm();
    auto& list = p.part<juce::ComboBox>("What was struck");
    const int withoutObject = list.getNumItems();
    CHECK(list.getText() == "The object of a mesh file");
    p.processor.setCurrentProgram(presetNumber("Steel Plate"));
    p.page.refresh();
    CHECK(list.getNumItems() == withoutObject + 1);
    CHECK(list.getText() == "The object that is shown");
    p.choose("A bowl, cup or pan"); // by hand, so that it stays
    p.part<juce::Label>("Outer diameter of the rim").setText("8.5", juce::sendNotificationSync);
    p.processor.setCurrentProgram(presetNumber("Marimba"));
    p.page.refresh();
    CHECK(list.getNumItems() == withoutObject);
    p.processor.setCurrentProgram(presetNumber("Steel Plate"));
    p.page.refresh();
    CHECK(list.getText() == "A bowl, cup or pan");
    CHECK(p.part<juce::Label>("Outer diameter of the rim").getText() == "8.5 cm");
    p.choose("The object that is shown");
    CHECK(p.part<juce::Label>("About what was struck").getText().toStdString() ==
          p.processor.view().materialFits.shownObject());
}

TEST_CASE(
    "A length is typed in the unit that it shows or with another; other text changes nothing") {
    LengthField field;
    field.show("Rim", "Diameter of the rim", 0.15);
    auto* text = find<juce::Label>(field, "Diameter of the rim");
    REQUIRE(text != nullptr);
    CHECK(text->getText() == "15 cm");
    text->setText("3 mm", juce::sendNotificationSync);
    CHECK(field.metres() == Approx(0.003));
    CHECK(text->getText() == "3 mm");
    text->setText("2.5", juce::sendNotificationSync);
    CHECK(text->getText() == "2.5 mm");
    text->setText("3 cm", juce::sendNotificationSync);
    text->setText("12.5", juce::sendNotificationSync);
    CHECK(text->getText() == "12.5 cm");
    text->setText("3 mm", juce::sendNotificationSync);
    for (const auto* wrong : {"wide", "-3", "0", "30 m"})
        text->setText(wrong, juce::sendNotificationSync);
    CHECK(field.metres() == Approx(0.003));
    CHECK(text->getText() == "3 mm");
}

TEST_CASE("What was struck is described in the sizes of its shape") {
    Page p;
    p.openForm();
    StruckChoice choice(p.processor.view().materialFits);
    auto* list = find<juce::ComboBox>(choice, "What was struck");
    REQUIRE(list != nullptr);
    list->setText("A bowl, cup or pan", juce::sendNotificationSync);
    RecordedStrike strike;
    choice.describe(strike);
    CHECK(strike.struck == RecordedStrike::Struck::shape);
    CHECK(strike.shape == "bowl");
    CHECK(strike.sizes.radiusMetres == Approx(0.075));
    CHECK(strike.sizes.footRadiusMetres == Approx(0.035));
    CHECK(strike.sizes.thicknessMetres == Approx(0.003));
    CHECK(choice.isComplete());
    list->setText("The object of a mesh file", juce::sendNotificationSync);
    CHECK_FALSE(choice.isComplete());
    list->setText("Unknown: only the damping", juce::sendNotificationSync);
    choice.describe(strike);
    CHECK(strike.struck == RecordedStrike::Struck::unknown);
}

TEST_CASE("A recording names the material; the form makes it and says what was found") {
    Page p;
    p.openForm();
    auto& make = p.part<juce::Button>("Make the material");
    p.choose("Unknown: only the damping");
    CHECK_FALSE(make.isEnabled());
    p.form().choose(
        recordedStrike("glass-cup.wav", {{440, 6, 0.4}, {1210, 11, 0.25}, {2370, 17, 0.15}}));
    auto& name = p.part<juce::TextEditor>("Name of the material");
    CHECK(name.getText() == "Glass cup");
    p.click("Make the material");
    CHECK(p.isShown("Cancel the fit"));
    CHECK_FALSE(p.isShown("Make the material"));
    const auto& fits = p.processor.view().materialFits;
    waitUntil([&] { return fits.fitStatus().stage != FitStage::working; },
              [&] { p.processor.poll(); });
    p.page.refresh();
    CHECK(p.isShown("Make the material"));
    CHECK(p.part<juce::TextEditor>("What was found").getText().startsWith("'Glass cup' is saved"));
    CHECK(p.part<juce::ComboBox>("Material").getText() == "Glass cup");
    p.click("Make the material");
    p.page.refresh();
    p.click("Cancel the fit");
    CHECK(p.part<juce::Label>("Progress").getText() == "Cancelled.");
}
