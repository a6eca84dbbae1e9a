// The window, without a screen: what it shows, what it changes, and that it never touches the
// sound.
#include "Plugin/TestSound.h"

#include "Instrument/FactoryContent.h"

#include <catch2/catch_test_macros.hpp>
#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>
#include <thread>

using namespace idiophone;
using namespace idiophone::test;

namespace {

void visit(juce::Component& component, const std::function<void(juce::Component&)>& action) {
    action(component);
    for (auto* child : component.getChildren())
        visit(*child, action);
}

template <class Kind>
Kind* find(juce::Component& window, const juce::String& title) {
    Kind* found = nullptr;
    visit(window, [&](juce::Component& component) {
        if (auto* candidate = dynamic_cast<Kind*>(&component);
            found == nullptr && candidate != nullptr && component.getTitle() == title)
            found = candidate;
    });
    return found;
}

std::unique_ptr<juce::AudioProcessorEditor> open(Processor& processor) {
    return std::unique_ptr<juce::AudioProcessorEditor>(processor.createEditor());
}

/// Lets the timers of the window and the processor run until it holds; a while at most.
bool holdsSoon(const std::function<bool()>& condition) {
    for (int i = 0; i < 500 && !condition(); ++i) {
        juce::Thread::sleep(10);
        juce::Timer::callPendingTimersSynchronously();
    }
    return condition();
}

juce::StringArray cutTexts(juce::Component& window) {
    juce::StringArray cut;
    visit(window, [&](juce::Component& component) {
        const auto* label = dynamic_cast<juce::Label*>(&component);
        // A list's label is beside its arrow and is squeezed by JUCE where it must.
        if (label == nullptr || dynamic_cast<juce::ComboBox*>(label->getParentComponent()))
            return;
        const float width =
            juce::GlyphArrangement::getStringWidth(label->getFont(), label->getText());
        if (width > static_cast<float>(label->getWidth()) ||
            label->getFont().getHeight() > static_cast<float>(label->getHeight()))
            cut.add(label->getText());
    });
    return cut;
}

} // namespace

TEST_CASE("At its smallest the window cuts no text, wherever the parameters are") {
    Processor processor;
    const auto window = open(processor);
    window->setSize(1080, 560);
    for (const double place : {0.0, 0.37, 1.0}) {
        for (const auto& info : parameterTable())
            processor.changeParameter(info.parameter, info.fromNormalised(place));
        const auto& last = parameterInfo(ParameterId::compression);
        REQUIRE(holdsSoon([&] {
            return find<juce::Slider>(*window, last.name)->getValue() ==
                   processor.parameterValue(last.parameter);
        }));
        CHECK(cutTexts(*window).joinIntoString(", ").toStdString() == "");
    }
}

TEST_CASE("At its smallest no two parameters overlap and all are inside the window") {
    Processor processor;
    const auto window = open(processor);
    for (const auto& [width, height] : {std::pair(1080, 560), {1280, 720}, {3840, 2160}}) {
        window->setSize(width, height);
        std::vector<juce::Rectangle<int>> places;
        for (const auto& info : parameterTable()) {
            auto* control = find<juce::Component>(*window, info.name);
            REQUIRE(control != nullptr);
            places.push_back(window->getLocalArea(control, control->getLocalBounds()));
            CHECK_FALSE(places.back().isEmpty());
            CHECK(window->getLocalBounds().contains(places.back()));
        }
        for (std::size_t i = 0; i < places.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                CHECK_FALSE(places[i].intersects(places[j]));
    }
}

TEST_CASE("A typed value is taken with its unit, exactly; what is no value changes nothing") {
    Processor processor;
    const auto window = open(processor);
    auto* value = find<juce::Label>(*window, "Density");
    REQUIRE(value != nullptr);
    value->setText("7850.1 kg/m3", juce::sendNotificationSync);
    CHECK(processor.parameterValue(ParameterId::density) == 7850.1);
    value->setText("heavy", juce::sendNotificationSync);
    CHECK(processor.parameterValue(ParameterId::density) == 7850.1);
    CHECK(value->getText() == "7850 kg/m3");
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
    CHECK(processor.parameterValue(ParameterId::tune) == -50);
    CHECK(processor.parameterValue(ParameterId::letRing) == 0);
    CHECK(processor.parameterValue(ParameterId::material) == double{firstLibraryMaterial});
}

TEST_CASE("The window follows automation and presets from elsewhere") {
    Processor processor;
    const auto window = open(processor);
    processor.setCurrentProgram(1);
    processor.getParameters()[static_cast<int>(ParameterId::density)]->setValue(1);
    CHECK(holdsSoon([&] {
        return find<juce::ComboBox>(*window, "Preset")->getText().toStdString() ==
                   factoryPresets()[1].name &&
               find<juce::Label>(*window, "Density")->getText() == "25000 kg/m3";
    }));
}

TEST_CASE("The preset list and its neighbour buttons choose presets, round the ends") {
    Processor processor;
    const auto window = open(processor);
    const int last = processor.getNumPrograms() - 1;
    find<juce::Button>(*window, "Previous preset")->onClick();
    CHECK(processor.getCurrentProgram() == last);
    find<juce::Button>(*window, "Next preset")->onClick();
    CHECK(processor.getCurrentProgram() == 0);
    find<juce::ComboBox>(*window, "Preset")->setSelectedId(2, juce::sendNotificationSync);
    CHECK(processor.getCurrentProgram() == 1);
}

TEST_CASE("The window opens and closes 100 times while the same notes sound the same") {
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
        window->setSize(1080 + i, 560 + i);
        window->createComponentSnapshot(window->getLocalBounds());
        juce::Timer::callPendingTimersSynchronously();
    }
    stop = true;
    audio.join();
    CHECK(rounds > 0);
    CHECK(same);
}
