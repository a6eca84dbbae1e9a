// Tests how a control shows its modulation, and how its menu changes it.
#include "Editor/ModulationEdit.h"

#include "Editor/Look.h"
#include "Editor/ModulationPage.h"
#include "Editor/ParameterControl.h"
#include "Editor/WindowParts.h"
#include "Plugin/Processor.h"
#include "Support/TestSound.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;
using enum ParameterId;

namespace {

/// A processor with a sound, and the menu of one of its parameters.
struct Rig {
    Rig() { restore(processor, testState()); }

    juce::PopupMenu menu(ParameterId target) {
        juce::PopupMenu items;
        addModulationItems(items, target, processor.view());
        return items;
    }
    /// Runs the enabled item with that text, also of a submenu. Returns whether there is one.
    bool choose(ParameterId target, const juce::String& text) {
        const auto items = menu(target);
        for (juce::PopupMenu::MenuItemIterator item(items, true); item.next();)
            if (item.getItem().text == text && item.getItem().isEnabled) {
                item.getItem().action();
                return true;
            }
        return false;
    }
    juce::String sentence(ParameterId target) {
        return modulationSentence(processor.view().parameters, target);
    }

    Processor processor;
    SoundHistory& history = processor.windowSession().history;
    ParameterView& parameters = processor.view().parameters;
};

bool samePixels(const juce::Image& a, const juce::Image& b) {
    for (int y = 0; y < a.getHeight(); ++y)
        for (int x = 0; x < a.getWidth(); ++x)
            if (a.getPixelAt(x, y) != b.getPixelAt(x, y))
                return false;
    return true;
}

} // namespace

TEST_CASE("The menu adds a modulation and ends it, each in one step of undo") {
    Rig rig;
    CHECK_FALSE(shownModulation(rig.parameters, tune));
    REQUIRE(rig.choose(tune, "LFO 1"));
    CHECK(rig.parameters.value(modulation1Source) == double(ModulationSource::lfo1));
    CHECK(rig.parameters.value(modulation1Target) == modulationTargetChoice(tune));
    CHECK(rig.parameters.value(modulation1Amount) == 25);
    CHECK(rig.sentence(tune) == "Modulated by LFO 1");
    CHECK(shownModulation(rig.parameters, tune)->highest == Approx(600));
    REQUIRE(rig.choose(tune, "Wheel"));
    CHECK(rig.sentence(tune) == "Modulated by LFO 1 and Wheel");
    CHECK(rig.history.undoName() == "Modulation");
    rig.history.undo();
    CHECK(rig.sentence(tune) == "Modulated by LFO 1");
    REQUIRE(rig.choose(tune, "Forget modulation by LFO 1"));
    CHECK(rig.sentence(tune).isEmpty());
    CHECK(rig.parameters.value(modulation1Amount) == 0);
    rig.history.undo();
    rig.history.undo();
    CHECK(rig.sentence(tune).isEmpty());
    CHECK_FALSE(rig.history.canUndo());
}

TEST_CASE("The menu takes free routes only, and says when there are none") {
    Rig rig;
    rig.parameters.changeOnce(modulation1Source, double(ModulationSource::wheel));
    for (std::size_t i = 0; i < routeCount; ++i)
        REQUIRE(rig.choose(decay, "Random"));
    CHECK_FALSE(rig.choose(tune, "Random"));
    juce::StringArray texts;
    const auto items = rig.menu(tune);
    for (juce::PopupMenu::MenuItemIterator item(items); item.next();)
        texts.add(item.getItem().text);
    CHECK(texts.contains("All eight modulations are in use"));
}

TEST_CASE("A parameter that modulation cannot move has no items for it") {
    Rig rig;
    CHECK(rig.menu(limiter).getNumItems() == 0);
}

TEST_CASE("A figure that is modulated becomes custom, so that it acts") {
    Rig rig;
    rig.parameters.changeOnce(material, firstLibraryMaterial + 8);
    const double steel = rig.parameters.effectiveValue(density);
    REQUIRE(rig.choose(density, "LFO 2"));
    CHECK(rig.parameters.value(material) == double{customMaterial});
    CHECK(rig.parameters.value(density) == Approx(steel));
    rig.history.undo();
    CHECK(rig.parameters.value(material) == double{firstLibraryMaterial} + 8);
}

TEST_CASE("Knobs and sliders mark how far modulation moves them, in both looks") {
    using Shape = ParameterControl::Shape;
    for (const auto scheme : {LookScheme::dark, LookScheme::light})
        for (const auto shape : {Shape::knob, Shape::row, Shape::bare}) {
            Rig rig;
            Look look(scheme);
            ParameterControl control(parameterInfo(tune), rig.processor.view(), shape);
            control.setLookAndFeel(&look);
            control.setSize(150, shape == Shape::knob ? 110 : 40);
            const auto picture = [&] {
                control.refresh();
                return control.createComponentSnapshot(control.getLocalBounds());
            };
            const auto plain = picture();
            REQUIRE(rig.choose(tune, "Velocity"));
            const auto modulated = picture();
            CHECK_FALSE(samePixels(plain, modulated));
            auto* slider = find<juce::Slider>(control, "Tune");
            REQUIRE(slider != nullptr);
            CHECK(slider->getDescription() == "Modulated by Velocity");
            CHECK(slider->getTooltip().contains("Modulated by Velocity"));
            rig.parameters.changeOnce(modulation1Amount, -50);
            CHECK_FALSE(samePixels(picture(), modulated));
            rig.history.undo();
            rig.history.undo();
            CHECK(samePixels(picture(), plain));
            CHECK(slider->getDescription().isEmpty());
            control.setLookAndFeel(nullptr);
        }
}

TEST_CASE("The page of modulation has a row of three controls for each route") {
    Rig rig;
    ModulationPage page(rig.processor.view());
    page.setSize(DeckPage::minimumWidth, DeckPage::minimumHeight);
    auto* target = find<juce::ComboBox>(page, "Modulation 8 target");
    REQUIRE(target != nullptr);
    target->setSelectedId(1 + modulationTargetChoice(size), juce::sendNotificationSync);
    CHECK(rig.parameters.value(modulation8Target) == modulationTargetChoice(size));
    CHECK(rig.history.undoName() == "Modulation 8 target");
    auto* amount = find<juce::Label>(page, "Modulation 8 amount");
    REQUIRE(amount != nullptr);
    amount->setText("-12.5", juce::sendNotificationSync);
    CHECK(rig.parameters.value(modulation8Amount) == -12.5);
    CHECK(amount->getText() == "-12.5 %");
}
