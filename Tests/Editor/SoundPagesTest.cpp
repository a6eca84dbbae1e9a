// Tests of the pages that show the sound, with a processor.
#include "Editor/ModesPage.h"
#include "Editor/ParameterPage.h"
#include "Editor/QualityPage.h"
#include "Editor/StrikePage.h"
#include "Editor/WindowParts.h"
#include "Plugin/Vst3Instrument.h"
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

template <class Kind>
Kind* childOf(juce::Component& page, const juce::String& title) {
    for (auto* child : page.getChildren())
        if (auto* found = dynamic_cast<Kind*>(child);
            found != nullptr && found->getTitle() == title)
            return found;
    return nullptr;
}

/// Plays a note and updates the page, as the window does on each timer tick.
void playAndShow(Processor& processor, DeckPage& page, int note) {
    processor.view().sound.takeSoundFrame();
    juce::MidiBuffer midi;
    midi.addEvent(juce::MidiMessage::noteOn(1, note, static_cast<juce::uint8>(100)), 0);
    render(processor, 4800, 480, midi);
    const auto* frame = processor.view().sound.takeSoundFrame();
    REQUIRE(frame != nullptr);
    page.showSound(*frame);
    page.refresh();
}

struct Prepared {
    Prepared() {
        restore(processor, testState());
        processor.prepareToPlay(48000, 480);
    }
    Processor processor;
};

} // namespace

TEST_CASE("The output page leaves out what has no effect in the plugin") {
    using enum ParameterId;
    const auto offered = [](Processor& processor) {
        ParameterPage page("Output", std::vector<ParameterGroup>{{"Output", 0}, {"Sound in", 1}},
                           processor.view());
        page.setSize(DeckPage::minimumWidth, DeckPage::minimumHeight);
        std::vector<ParameterId> parameters;
        visit(page, [&](juce::Component& part) {
            if (const auto* control = dynamic_cast<const ParameterControl*>(&part))
                parameters.push_back(control->parameter().parameter);
        });
        return parameters;
    };
    using Parameters = std::vector<ParameterId>;
    Processor standalone, resonator(PluginKind::resonator);
    Vst3Instrument vst3;
    CHECK(offered(standalone) == Parameters{level, limiter, bypass});
    CHECK(offered(resonator) ==
          Parameters{level, limiter, bypass, inputDrive, inputLowCut, dryWet});
    CHECK(offered(*vst3.processor) ==
          Parameters{level, limiter, outputs, bypass, inputDrive, inputLowCut});
}

TEST_CASE("The modes page shows the object played last, or the chosen one") {
    Prepared prepared;
    ModesPage page(prepared.processor.view());
    page.setSize(DeckPage::minimumWidth, DeckPage::minimumHeight);
    auto* list = childOf<juce::ComboBox>(page, "Object");
    auto* spectrum = childOf<ModeSpectrum>(page, "Modes");
    REQUIRE(list != nullptr);
    REQUIRE(spectrum != nullptr);
    playAndShow(prepared.processor, page, 69);
    CHECK(spectrum->frameShown().object == 9);
    CHECK(list->getNumItems() == 1 + highestTestNote - lowestTestNote + 1);
    CHECK(list->getText() == "Played last");
    list->setSelectedId(4, juce::sendNotificationSync);
    CHECK(prepared.processor.view().sound.watchedObject() == 2);
    playAndShow(prepared.processor, page, 69);
    CHECK(spectrum->frameShown().object == 2);
    restore(prepared.processor, testState("other"));
    playAndShow(prepared.processor, page, 64);
    CHECK(list->getText() == "Played last");
    CHECK(spectrum->frameShown().object == 4);
}

TEST_CASE("The buttons mute and solo the chosen mode, and restore all modes") {
    Prepared prepared;
    auto& processor = prepared.processor;
    ModesPage page(processor.view());
    page.setSize(DeckPage::minimumWidth, DeckPage::minimumHeight);
    page.setVisible(true);
    auto* mute = childOf<juce::TextButton>(page, "Mute mode");
    auto* alone = childOf<juce::TextButton>(page, "Solo mode");
    auto* all = childOf<juce::TextButton>(page, "Hear all modes");
    auto* spectrum = childOf<ModeSpectrum>(page, "Modes");
    std::optional<std::size_t> told;
    page.onModeShown = [&](std::optional<std::size_t> mode) { told = mode; };
    playAndShow(processor, page, 69);
    CHECK_FALSE(mute->isEnabled());
    spectrum->choose(1);
    CHECK(told == 1);
    CHECK(mute->isEnabled());
    mute->onClick();
    alone->onClick();
    playAndShow(processor, page, 69);
    CHECK(mute->getToggleState());
    CHECK(alone->getToggleState());
    CHECK(spectrum->frameShown().modes[0].standing == ModeStanding::silenced);
    CHECK(spectrum->frameShown().modes[1].standing == ModeStanding::sounding);
    CHECK(all->isEnabled());
    all->onClick();
    playAndShow(processor, page, 69);
    CHECK_FALSE(mute->getToggleState());
    CHECK_FALSE(all->isEnabled());
    CHECK(spectrum->frameShown().modes[0].standing == ModeStanding::sounding);
    page.setVisible(false);
    CHECK(told == std::nullopt);
}

TEST_CASE("The quality page counts modes and shows each object's share of the budget") {
    Prepared prepared;
    QualityPage page(prepared.processor.view());
    page.setSize(DeckPage::minimumWidth, DeckPage::minimumHeight);
    auto* ramp = childOf<BudgetRamp>(page, "Shares of the budget");
    auto* meters = childOf<SoundMeters>(page, "Level and load");
    REQUIRE(ramp != nullptr);
    REQUIRE(meters != nullptr);
    prepared.processor.view().parameters.change(ParameterId::modeBudget, 16);
    prepared.processor.view().parameters.change(ParameterId::letRing, 1);
    for (const int note : {60, 64, 67, 72})
        playAndShow(prepared.processor, page, note);
    CHECK(ramp->description() == "16 of 16 modes for 4 objects");
    CHECK_FALSE(meters->description().contains("silent"));
    const juce::Rectangle<int> inside = page.getLocalBounds();
    for (const auto* child : page.getChildren()) {
        CHECK(inside.contains(child->getBounds()));
        if (dynamic_cast<const juce::ComboBox*>(child) == nullptr)
            CHECK(child->getHeight() >= 48);
    }
}

TEST_CASE("The velocity graph marks the last strike and repaints for nothing else") {
    Prepared prepared;
    StrikePage page(prepared.processor.view());
    page.setSize(DeckPage::minimumWidth, DeckPage::minimumHeight);
    page.setVisible(true);
    auto* graph = childOf<VelocityGraph>(page, "Velocity graph");
    REQUIRE(graph != nullptr);
    int repaints = 0;
    graph->setCachedComponentImage(new RepaintCount(repaints)); // the graph owns it
    repaints = 0;
    playAndShow(prepared.processor, page, 69);
    CHECK(repaints == 1);
    playAndShow(prepared.processor, page, 64); // as hard
    CHECK(repaints == 1);
    prepared.processor.view().parameters.change(ParameterId::velocityCurve, 2.5);
    page.refresh();
    page.refresh();
    CHECK(repaints == 2);
}

TEST_CASE("A quality sets four parameters in one step, and values of none are called Own") {
    using enum ParameterId;
    Prepared prepared;
    auto& parameters = prepared.processor.view().parameters;
    QualityPage page(prepared.processor.view());
    auto* list = childOf<juce::ComboBox>(page, "Quality");
    REQUIRE(list != nullptr);
    CHECK(list->getText() == "Normal");
    const auto choose = [&](const char* name) {
        for (int i = 0; i < list->getNumItems(); ++i)
            if (list->getItemText(i) == name)
                list->setSelectedItemIndex(i, juce::sendNotificationSync);
        page.refresh();
    };
    choose("Eco");
    CHECK(list->getText() == "Eco");
    CHECK(parameters.value(tau) > parameterInfo(tau).defaultValue);
    CHECK(parameters.value(compression) > parameterInfo(compression).defaultValue);
    CHECK(parameters.value(modeBudget) < parameterInfo(modeBudget).defaultValue);
    CHECK(prepared.processor.windowSession().history.undoName() == "Quality");
    prepared.processor.windowSession().history.undo();
    CHECK_FALSE(prepared.processor.windowSession().history.canUndo());
    page.refresh();
    CHECK(list->getText() == "Normal");
    choose("High");
    CHECK(parameters.value(tau) < parameterInfo(tau).defaultValue);
    CHECK(parameters.value(modeBudget) == parameterInfo(modeBudget).maximum);
    parameters.changeOnce(qualitySlope, 2);
    page.refresh();
    CHECK(list->getText() == "Own");
    choose("Normal");
    for (const auto parameter : {tau, compression, modeBudget, qualitySlope})
        CHECK(parameters.value(parameter) == parameterInfo(parameter).defaultValue);
}

TEST_CASE("The mallet's figures come first on the page, above speed and velocity curve") {
    Prepared prepared;
    StrikePage page(prepared.processor.view());
    page.setSize(DeckPage::minimumWidth, DeckPage::minimumHeight);
    int above = 0;
    for (const auto parameter :
         {ParameterId::malletHardness, ParameterId::malletMass, ParameterId::malletRadius,
          ParameterId::malletSpeed, ParameterId::velocityCurve}) {
        const auto* slider = find<juce::Slider>(page, parameterInfo(parameter).name);
        REQUIRE(slider != nullptr);
        const int y = page.getLocalPoint(slider, juce::Point<int>()).y;
        CHECK(y > above);
        above = y;
    }
}
