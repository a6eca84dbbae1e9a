// Tests of the plugin need JUCE's message manager, though no display.
#include <catch2/catch_session.hpp>
#include <juce_events/juce_events.h>

int main(int argumentCount, char* arguments[]) {
    const juce::ScopedJuceInitialiser_GUI juce;
    return Catch::Session().run(argumentCount, arguments);
}
