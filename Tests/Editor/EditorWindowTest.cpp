// Tests of the window, without a screen: its texts, its changes, and that it keeps the sound.
#include "Editor/EditorWindow.h"
#include "Editor/MaterialPad.h"
#include "Editor/MaterialPage.h"
#include "Editor/Mouse.h"
#include "Editor/OpenWindow.h"
#include "Editor/Preferences.h"
#include "Editor/WindowParts.h"
#include "Plugin/FactoryPrograms.h"
#include "Plugin/Vst3Instrument.h"
#include "Support/GestureLog.h"
#include "Support/TestSound.h"
#include "Support/UserSettings.h"

#include "Instrument/FactoryContent.h"

#include <algorithm>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <set>
#include <thread>
#include <typeinfo>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

juce::StringArray cutTexts(juce::Component& window) {
    juce::StringArray cut;
    visit(window, [&](juce::Component& component) {
        const auto* label = dynamic_cast<juce::Label*>(&component);
        // JUCE squeezes a list's label beside its arrow.
        if (label == nullptr || !isOnScreen(*label, window) ||
            dynamic_cast<juce::ComboBox*>(label->getParentComponent()))
            return;
        const float width =
            juce::GlyphArrangement::getStringWidth(label->getFont(), label->getText());
        if (width > static_cast<float>(label->getWidth()) ||
            label->getFont().getHeight() > static_cast<float>(label->getHeight()))
            cut.add(label->getText());
    });
    return cut;
}

/// The contrast of two colours, 1 to 21 (WCAG 2.1).
float contrastOf(juce::Colour a, juce::Colour b) {
    const auto luminance = [](juce::Colour colour) {
        const auto linear = [](float part) {
            return part <= 0.04045f ? part / 12.92f : std::pow((part + 0.055f) / 1.055f, 2.4f);
        };
        return 0.2126f * linear(colour.getFloatRed()) + 0.7152f * linear(colour.getFloatGreen()) +
               0.0722f * linear(colour.getFloatBlue());
    };
    const float high = std::max(luminance(a), luminance(b));
    return (high + 0.05f) / (std::min(luminance(a), luminance(b)) + 0.05f);
}

PageDeck& deckOf(juce::Component& window) {
    auto* deck = find<PageDeck>(window, "Pages");
    REQUIRE(deck != nullptr);
    return *deck;
}

const auto sizes = {std::pair(WindowSize::minimumWidth, WindowSize::minimumHeight),
                    {1180, 860},
                    {1280, 720},
                    {1920, 600},
                    {3840, 2160}};

} // namespace

TEST_CASE("The window cuts no text at any size and any parameter value") {
    Vst3Instrument vst3;
    auto& processor = *vst3.processor;
    const auto window = open(processor);
    auto& deck = deckOf(*window);
    for (const auto& [width, height] : sizes) {
        window->setSize(width, height);
        for (const double place : {0.0, 0.37, 1.0}) {
            for (const auto& info : parameterTable())
                processor.view().parameters.change(info.parameter, info.fromNormalised(place));
            for (int page = 0; page < deck.pageCount(); ++page) {
                deck.show(page);
                deck.refresh();
                INFO(width << " x " << height << ", page " << page);
                CHECK(cutTexts(*window).joinIntoString(", ").toStdString() == "");
            }
        }
    }
}

TEST_CASE("Each parameter is inside a page at every window size, and controls do not overlap") {
    Vst3Instrument vst3; // offers most of them
    auto& processor = *vst3.processor;
    const auto window = open(processor);
    auto& deck = deckOf(*window);
    for (const auto& [width, height] : sizes) {
        window->setSize(width, height);
        std::set<ParameterId> seen;
        for (int page = 0; page < deck.pageCount(); ++page) {
            deck.show(page);
            std::vector<juce::Rectangle<int>> places;
            for (const auto& info : parameterTable()) {
                auto* control = find<juce::Component>(*window, info.name);
                REQUIRE((control != nullptr) == (info.parameter != ParameterId::dryWet));
                if (control == nullptr)
                    continue;
                if (!isOnScreen(*control, *window))
                    continue;
                seen.insert(info.parameter);
                places.push_back(window->getLocalArea(control, control->getLocalBounds()));
                INFO(width << " x " << height << ", " << info.name);
                CHECK_FALSE(places.back().isEmpty());
                CHECK(window->getLocalBounds().contains(places.back()));
            }
            for (std::size_t i = 0; i < places.size(); ++i)
                for (std::size_t j = 0; j < i; ++j)
                    CHECK_FALSE(places[i].intersects(places[j]));
        }
        CHECK(seen.size() == parameterCount - 1);
    }
}

TEST_CASE("The tabs keep a distance from each other at every width") {
    Processor processor;
    const auto window = open(processor);
    auto& deck = deckOf(*window);
    const auto font = Look::headingFont(13.5f);
    for (const int width : {PageDeck::widthFor(1), 500, 640, PageDeck::widthFor(2), 1600}) {
        deck.setSize(width, PageDeck::minimumHeight);
        std::vector<juce::Rectangle<int>> names;
        for (auto* child : deck.getChildren())
            if (auto* tab = dynamic_cast<juce::Button*>(child)) {
                const int text =
                    juce::GlyphArrangement::getStringWidthInt(font, tab->getButtonText());
                names.push_back(tab->getBounds().withSizeKeepingCentre(text, tab->getHeight()));
                INFO(width << ", " << tab->getButtonText());
                CHECK(deck.getLocalBounds().contains(tab->getBounds()));
                for (std::size_t i = 0; i + 1 < names.size(); ++i)
                    CHECK_FALSE(names[i].expanded(6, 0).intersects(names.back().expanded(6, 0)));
                for (auto* page : deck.getChildren())
                    if (dynamic_cast<DeckPage*>(page) != nullptr && page->isVisible())
                        CHECK(page->getY() >= tab->getBottom());
            }
        CHECK(static_cast<int>(names.size()) == deck.pageCount() + 1); // the switch of units too
    }
}

TEST_CASE("Dialogs of the process wear the look of the window, and JUCE's after it has closed") {
    Processor processor;
    const auto background = [] {
        return juce::LookAndFeel::getDefaultLookAndFeel().findColour(
            juce::AlertWindow::backgroundColourId);
    };
    const auto before = background();
    {
        EditorWindow first(processor, processor.view());
        { const EditorWindow second(processor, processor.view()); }
        first.setLook(LookScheme::light);
        CHECK(background() == colourOf(LookScheme::light, LookColour::panel));
        first.setLook(LookScheme::dark);
        CHECK(background() == colourOf(LookScheme::dark, LookColour::panel));
    }
    CHECK(background() == before);
}

TEST_CASE("Names and details in the file chooser are readable in both looks, selected or not") {
    juce::TimeSliceThread thread("files");
    juce::DirectoryContentsList files(nullptr, thread);
    juce::FileListComponent list(files);
    for (const auto scheme : {LookScheme::dark, LookScheme::light})
        for (const bool isSelected : {false, true}) {
            Look look(scheme);
            juce::Image row(juce::Image::RGB, 700, 24, true);
            juce::Graphics g(row);
            g.fillAll(colourOf(scheme, LookColour::panel));
            look.drawFileBrowserRow(g, 700, 24, juce::File(), "|||||||||||||", nullptr, "||||||||",
                                    "||||||||||||", false, isSelected, 0, list);
            const auto contrastIn = [&](int from, int to) {
                float darkest = 1, brightest = 0;
                for (int x = from; x < to; ++x) {
                    const float here = row.getPixelAt(x, 12).getPerceivedBrightness();
                    darkest = std::min(darkest, here);
                    brightest = std::max(brightest, here);
                }
                return brightest - darkest;
            };
            CHECK(contrastIn(32, 120) > 0.3f);
            CHECK(contrastIn(580, 690) > 0.2f);
            CHECK(contrastIn(510, 570) > 0.2f);
        }
}

TEST_CASE("Every enabled control has an accessible name") {
    Vst3Instrument vst3;
    auto& processor = *vst3.processor;
    const auto window = open(processor);
    window->setSize(3840, 2160);
    juce::StringArray nameless;
    visit(*window, [&](juce::Component& component) {
        if (component.getWantsKeyboardFocus() && component.isEnabled() &&
            isOnScreen(component, *window) && component.getTitle().isEmpty())
            nameless.add(typeid(component).name());
    });
    CHECK(nameless.joinIntoString(", ").toStdString() == "");
}

TEST_CASE("Text contrast meets WCAG AA in both looks") {
    using enum LookColour;
    for (const auto scheme : {LookScheme::dark, LookScheme::light}) {
        for (const auto back : {background, panel})
            for (const auto front : {text, dimText, accent, error, held})
                CHECK(contrastOf(colourOf(scheme, front), colourOf(scheme, back)) >= 4.5f);
        CHECK(contrastOf(colourOf(scheme, onAccent), colourOf(scheme, accent)) >= 4.5f);
        CHECK(contrastOf(colourOf(scheme, text), colourOf(scheme, outline)) >= 4.5f);
    }
}

TEST_CASE("The hint in an empty field meets WCAG AA in both looks") {
    const UserSettings user;
    Processor processor;
    EditorWindow window(processor, processor.view());
    int fields = 0;
    for (const auto scheme : {LookScheme::dark, LookScheme::light}) {
        window.setLook(scheme);
        visit(window, [&](juce::Component& part) {
            auto* field = dynamic_cast<juce::TextEditor*>(&part);
            if (field == nullptr || field->getTextToShowWhenEmpty().isEmpty())
                return;
            ++fields;
            field->setSize(400, 28);
            field->clear();
            const auto picture = field->createComponentSnapshot({2, 2, 396, 24}, true, 4);
            const auto back = picture.getPixelAt(picture.getWidth() - 1, picture.getHeight() / 2);
            float highest = 1;
            for (int y = 0; y < picture.getHeight(); ++y)
                for (int x = 0; x < picture.getWidth(); ++x)
                    highest = std::max(highest, contrastOf(picture.getPixelAt(x, y), back));
            INFO(field->getTitle());
            CHECK(highest >= 4.5f);
        });
    }
    CHECK(fields == 8); // the search, and three of the form, in each look
}

TEST_CASE("Text typed in one look is readable in the other") {
    Processor processor;
    auto window = open(processor);
    auto* search = find<juce::TextEditor>(*window, "Search presets");
    auto* look = find<juce::TextButton>(*window, "Light look");
    REQUIRE(search != nullptr);
    REQUIRE(look != nullptr);
    search->setSize(300, 28);
    search->setText("||||||||||||||||");
    const auto contrast = [&] {
        const auto picture = search->createComponentSnapshot(search->getLocalBounds());
        float darkest = 1, brightest = 0;
        for (int x = 8; x < 60; ++x) {
            const float here = picture.getPixelAt(x, 14).getPerceivedBrightness();
            darkest = std::min(darkest, here);
            brightest = std::max(brightest, here);
        }
        return brightest - darkest;
    };
    for (int times = 0; times < 3; ++times) {
        CHECK(contrast() > 0.3f);
        look->onClick();
    }
}

TEST_CASE("A typed value is set exactly in its unit; invalid text changes nothing") {
    Processor processor;
    const auto window = open(processor);
    auto* value = find<juce::Label>(*window, "Density");
    REQUIRE(value != nullptr);
    value->setText("7850.1 kg/m3", juce::sendNotificationSync);
    CHECK(processor.view().parameters.value(ParameterId::density) == 7850.1);
    value->setText("heavy", juce::sendNotificationSync);
    CHECK(processor.view().parameters.value(ParameterId::density) == 7850.1);
    CHECK(value->getText() == "85"); // of 10 to 25000 kg/m³
}

TEST_CASE("Controls show the figures in effect; a change by hand makes them all custom") {
    using enum ParameterId;
    Processor processor;
    const auto window = open(processor);
    processor.view().parameters.change(material, firstLibraryMaterial + 8); // steel
    processor.view().parameters.change(mallet, firstRackMallet);            // yarn
    auto* modulus = find<juce::Label>(*window, "Stiffness");
    runTimersUntil([&] { return modulus->getText() == "86"; }); // 200 GPa of 0.01 to 1000
    CHECK(find<juce::Label>(*window, "Mallet weight")->getText() == "59"); // 40 g of 1 to 500
    CHECK(processor.view().parameters.value(youngsModulus) != 200);

    modulus->setText("100 GPa", juce::sendNotificationSync);
    CHECK(processor.view().parameters.value(material) == double{customMaterial});
    CHECK(processor.view().parameters.value(youngsModulus) == 100);
    CHECK(processor.view().parameters.value(density) == 7850);
    CHECK(processor.view().parameters.value(fluidDamping) ==
          Approx(findMaterial("Steel")->damping.fluidPerSecond));
    CHECK(processor.view().parameters.value(lossFactor) ==
          Approx(findMaterial("Steel")->damping.lossFactor));
    CHECK(processor.view().parameters.value(mallet) == double{firstRackMallet});
    find<juce::Label>(*window, "Mallet size")->setText("20 mm", juce::sendNotificationSync);
    CHECK(processor.view().parameters.value(mallet) == double{customMallet});
    CHECK(processor.view().parameters.value(malletRadius) == 20);
    CHECK(processor.view().parameters.value(malletMass) == Approx(40));
}

TEST_CASE("A material made for a place of the map lies at that place") {
    const auto library = materialLibrary();
    for (double fast = 0; fast <= 1; fast += 0.125)
        for (double ringing = 0; ringing <= 1; ringing += 0.125) {
            const auto place = placeOf(materialAt({fast, ringing}, library));
            CHECK(place.fast == Approx(fast).margin(1e-9));
            CHECK(place.ringing == Approx(ringing).margin(1e-9));
        }
    const auto& steel = *findMaterial("Steel");
    const auto again = materialAt(placeOf(steel), library);
    CHECK(again.youngsModulusPa == Approx(steel.youngsModulusPa).epsilon(1e-4));
    CHECK(again.densityKgPerM3 == Approx(steel.densityKgPerM3).epsilon(1e-4));
    CHECK(again.damping.fluidPerSecond == Approx(steel.damping.fluidPerSecond).epsilon(1e-3));
    CHECK(again.damping.lossFactor == Approx(steel.damping.lossFactor).epsilon(1e-3));
}

TEST_CASE("Swapping materials twice restores the material after the last change") {
    using enum ParameterId;
    Processor processor;
    MaterialPage page(processor.view());
    const auto tick = [&](int times) {
        for (int i = 0; i < times; ++i)
            page.refresh();
    };
    tick(20);
    processor.view().parameters.change(material, firstLibraryMaterial + 4);
    tick(20);
    processor.view().parameters.change(material, firstLibraryMaterial + 8);
    tick(20);
    processor.view().parameters.changeOnce(density, 1234); // makes it custom
    tick(20);
    page.swapMaterials();
    CHECK(processor.windowSession().history.undoName() == "Material");
    CHECK(processor.view().parameters.value(material) == double{firstLibraryMaterial} + 8);
    page.swapMaterials();
    CHECK(processor.view().parameters.value(density) == 1234);
    processor.view().parameters.change(material, firstLibraryMaterial + 4);
    tick(20);
    processor.view().parameters.change(material, firstLibraryMaterial + 8);
    tick(20);
    page.swapMaterials();
    CHECK(processor.view().parameters.value(material) == double{firstLibraryMaterial} + 4);
    page.swapMaterials();
    CHECK(processor.view().parameters.value(material) == double{firstLibraryMaterial} + 8);
}

TEST_CASE("Sliders, switches and lists change their parameter in its unit") {
    Processor processor;
    const auto window = open(processor);
    auto* tuning = find<juce::Slider>(*window, "Tune");
    auto* ring = find<juce::ToggleButton>(*window, "Let ring");
    auto* material = find<juce::ComboBox>(*window, "Material");
    REQUIRE((tuning != nullptr && ring != nullptr && material != nullptr));
    tuning->setValue(-50, juce::sendNotificationSync);
    ring->setToggleState(false, juce::sendNotificationSync);
    material->setSelectedId(firstLibraryMaterial + 1, juce::sendNotificationSync);
    CHECK(processor.view().parameters.value(ParameterId::tune) == -50);
    CHECK(processor.view().parameters.value(ParameterId::letRing) == 0);
    CHECK(processor.view().parameters.value(ParameterId::material) == double{firstLibraryMaterial});
}

TEST_CASE("The list of materials shows the name of the objects' own material") {
    Processor processor;
    auto window = open(processor);
    auto* list = find<juce::ComboBox>(*window, "Material");
    REQUIRE(list != nullptr);
    CHECK(list->getText() == "Own (Rosewood)");
    REQUIRE(processor.view().presets.loadPreset(factoryPresetId("Steel Ring")));
    runTimersUntil([&] { return list->getText().startsWith("Own (Steel"); });
}

TEST_CASE("The window follows automation and program changes of the host") {
    Processor processor;
    const auto window = open(processor);
    processor.setCurrentProgram(1);
    processor.view().parameters.change(ParameterId::material, customMaterial);
    processor.getParameters()[static_cast<int>(ParameterId::density)]->setValue(1);
    runTimersUntil([&] {
        return find<juce::Button>(*window, "Preset")->getButtonText().toStdString() ==
                   factoryPresets()[1].name &&
               find<juce::Label>(*window, "Density")->getText() == "100";
    });
}

TEST_CASE("Opening and closing the window 100 times does not change the sound") {
    const auto song = [](Processor& processor) {
        return render(processor, 48000, 256, testMusic(48000));
    };
    Processor alone;
    restore(alone, testState());
    alone.prepareToPlay(48000, 256);
    const auto expected = song(alone);

    Processor processor;
    restore(processor, testState());
    processor.prepareToPlay(48000, 256);
    std::atomic<bool> same{true}, stop{false};
    std::atomic<int> rounds{0};
    std::thread audio([&] {
        while (!stop) {
            processor.reset();
            if (song(processor) != expected)
                same = false;
            ++rounds;
        }
    });
    for (int i = 0; i < 100; ++i) {
        const auto window = open(processor);
        window->setSize(WindowSize::minimumWidth + 7 * i, WindowSize::minimumHeight + 5 * i);
        window->createComponentSnapshot(window->getLocalBounds());
        juce::Timer::callPendingTimersSynchronously();
    }
    stop = true;
    audio.join();
    CHECK(rounds > 0);
    CHECK(same);
}

TEST_CASE("A restored window fits the screen and has at least the minimum size") {
    const UserSettings user;
    { Preferences().setWindowSize({100000, 10}); }
    Processor processor;
    auto window = open(processor);
    CHECK(window->getWidth() <= WindowSize::maximumWidth);
    CHECK(window->getHeight() == WindowSize::minimumHeight);
    window.reset();
    const Preferences after;
    CHECK(after.windowSize().y == WindowSize::minimumHeight);
}

TEST_CASE("One window's saved preferences do not overwrite another's") {
    const UserSettings user;
    Preferences first;
    { Preferences().setLook(LookScheme::light); }
    first.setWindowSize({1000, 700});
    CHECK(first.look() == LookScheme::light);
}

TEST_CASE("A window that closes during a drag ends the gesture for the host") {
    Processor processor;
    GestureLog host;
    processor.addListener(&host);
    auto window = open(processor);
    processor.view().parameters.beginChange(ParameterId::density);
    processor.view().parameters.change(ParameterId::density, 1000);
    CHECK(host.text == "(=");
    window.reset();
    CHECK(host.text == "(=)");
    processor.view().parameters.endChange(ParameterId::density);
    processor.removeListener(&host);
    CHECK(host.text == "(=)");
    CHECK(processor.windowSession().history.undoName() == "Density");
}

TEST_CASE("A window that closes while the mouse holds a control makes one gesture and one step") {
    Processor processor;
    GestureLog host;
    processor.addListener(&host);
    for (const char* name : {"Size", "Mallet speed"}) { // a knob and a row
        INFO(name);
        auto window = open(processor);
        window->setSize(3840, 2160);
        auto& slider = *find<juce::Slider>(*window, name);
        slider.mouseDown(mouseAt(slider, {30, 8}, {30, 8}));
        slider.mouseDrag(mouseAt(slider, {60, 2}, {30, 8}));
        CHECK(host.text.startsWith("(="));
        window.reset();
        CHECK(host.text.retainCharacters("()") == "()");
        CHECK(processor.windowSession().history.undoName() == name);
        host.text.clear();
    }
    processor.removeListener(&host);
}
